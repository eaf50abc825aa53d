// How is a question of my own put to functions?  A kind made of an argument list and of whatever knows the answer.
//
//   const Kind mine = formula_kind<InAnnulus>();                     // the sign of a formula (certify/formula.hpp)
//   const Kind mine = own_kind({.name = "point-in-wedge",            // or any code that is exact
//                               .arguments = {points("p", 2), points("wedge", 2, 3)},
//                               .form = AnswerForm::yes_no,
//                               .exact = [](std::span<const double> q) { return Answer(in_wedge(q) ? 1.0 : 0.0); }});
//   EXPECT_TRUE(check(mine, my_function).clean());
//
// Points, directions, boxes along the axes, lengths, and any number of points come from the families of hard inputs
// (degenerate/family.hpp), all points of a case together, so that they are degenerate together; and where the answer is
// a sign or yes or no, from "at_change": a number is moved until the answer changes between it and the next double.
// Laws: those of degenerate/kind.hpp, of which (1), that the answers are exact, is the user's: what `exact` answers is
// taken for right.  Where it answers NaN, nothing is wrong.  A kind that has no generator, or that no C function can be
// asked for (more than twelve arguments; triangles; names that are no identifiers), throws Error.
// Source: none.
// Cost: that of `exact`, once a case, some 64 times a case of "at_change".
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plumb/certify/decide.hpp"
#include "plumb/degenerate/family.hpp"
#include "plumb/degenerate/kind.hpp"

namespace plumb::degenerate {

struct OwnKind {
  std::string name;
  std::string question = {}, convention = {};  // for reports; empty: made up from the name
  std::vector<Argument> arguments;
  AnswerForm form = AnswerForm::sign;  // or yes_no, number
  Exact exact;
  std::optional<Degeneracy> aim = {};      // of the points; nothing: each in turn
  std::vector<Generator> generators = {};  // beside those that are made
  Tolerance tolerance = {};                // of numbers
};

/// The function asked is `double f(...)`, of yes_no `int f(...)`, with `const double*` for each argument and a `size_t`
/// after those of any number of points.
Kind own_kind(OwnKind described);

inline Argument points(std::string name, int dimension, std::size_t count = 1) {
  return {std::move(name), {{Role::points, dimension, count}}};
}
/// At least so many; the function is told how many.
inline Argument any_points(std::string name, int dimension, std::size_t least = 1) {
  return {std::move(name), {{Role::points, dimension}}, least};
}
inline Argument direction(std::string name, int dimension) { return {std::move(name), {{Role::vector, dimension}}}; }
/// Its least corner, then its largest.
inline Argument box(std::string name, int dimension) { return {std::move(name), {{Role::corners, dimension, 2}}}; }
/// Numbers that are not negative: radii, half extents.
inline Argument lengths(std::string name, int count = 1) { return {std::move(name), {{Role::extents, count}}}; }

/// What is known of a formula where it is not a type any more.
struct FormulaShape {
  std::string_view name;
  std::span<const int> arguments;
  std::span<const std::string_view> argument_names = {};  // none: a, b, c, ...
  std::function<Sign(std::span<const double> coordinates)> sign;
};
Kind formula_kind(const FormulaShape& shape, std::optional<Degeneracy> aim = {});

/// The sign of the formula, whose arguments are points of their number of coordinates.
template <Formula F>
Kind formula_kind(std::optional<Degeneracy> aim = {}) {
  const auto sign = [](std::span<const double> x) {
    Coordinates<F> coordinates{};
    std::ranges::copy(x, coordinates.begin());
    return decide<F>(coordinates);
  };
  return formula_kind({F::name, arguments<F>, argument_names<F>, sign}, aim);
}

}  // namespace plumb::degenerate
