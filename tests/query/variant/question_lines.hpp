// Questions of every form, of figures of every kind at each place.
#pragma once

#include <vector>

#include "plumb/query/variant/question_line.hpp"
#include "query/variant/all_kinds.hpp"

namespace plumb {

/// The same of a seed on every machine.
inline std::vector<QuestionLine> question_lines(std::uint64_t seed) {
  pair_cases::Material m(seed, 0);
  const std::vector<AnyFigure> all = pair_cases::all_kinds(m);
  const auto in = [&](int dimension) {
    std::vector<AnyFigure> some;
    for (const AnyFigure& s : all)
      if (s.dimension() == dimension) some.push_back(s);
    return some;
  };
  std::vector<QuestionLine> lines;
  for (const QuestionForm& form : question_forms()) {
    const auto ask = [&](std::vector<AnyFigure> figures) {
      std::vector<double> numbers;
      for (std::size_t i = 0; i < form.numbers; ++i)
        numbers.push_back(static_cast<double>(i % 3) * (figures[0].dimension() == 2 ? 0 : 1));
      lines.push_back({std::string(form.name), std::move(figures), std::move(numbers), ""});
    };
    for (const int dimension : {2, 3}) {
      const std::vector<AnyFigure> some = in(dimension);
      for (const AnyFigure& a : some) {
        if (form.figures == 1) ask({a});
        if (form.figures == 1) continue;
        for (const AnyFigure& b : some) {
          if (form.figures == 2) ask({a, b});
          if (form.figures == 4) ask({a, a, b, b});
        }
      }
    }
  }
  return lines;
}

}  // namespace plumb
