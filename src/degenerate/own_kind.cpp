#include "plumb/degenerate/own_kind.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "degenerate/families_of_cases.hpp"
#include "degenerate/fields.hpp"
#include "degenerate/own_call.hpp"
#include "degenerate/reserved_names.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/degenerate/ulps.hpp"

namespace plumb::degenerate {

namespace {

constexpr std::size_t kMorePoints = 8;  // than the least, of an argument that may have any number

[[noreturn]] void refuse(const OwnKind& own, std::string_view why) {
  throw Error(std::string("own_kind: ").append(own.name).append(": ").append(why));
}

/// Letters, digits, `_` and what else is `allowed`, beginning with a letter.
bool is_name(std::string_view name, char allowed) {
  const auto letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  const auto fits = [&](char c) {
    return letter(c) || std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '_' || c == allowed;
  };
  return !name.empty() && letter(name[0]) && std::ranges::all_of(name, fits);
}

bool is_made(Role role) {
  return role == Role::points || role == Role::vector || role == Role::corners || role == Role::extents;
}

void require_sense(const OwnKind& own) {
  if (!is_name(own.name, '-'))
    refuse(own, "a name of letters, digits, '-' and '_' is wanted: it begins the lines of its cases");
  if (!own.exact) refuse(own, "what knows the answer is wanted: a function in `exact`");
  if (own.form == AnswerForm::hit || own.form == AnswerForm::triangles)
    refuse(own, "a sign, yes or no, or a number can be answered");
  bool made = true;
  for (const Argument& a : own.arguments) {
    if (!is_name(a.name, '_')) refuse(own, "'" + a.name + "' is no name for an argument: letters, digits and '_' are");
    if (is_keyword_of_c_or_cpp(a.name))
      refuse(own, a.name + " is a keyword of C or C++; give the argument another name");
    if (std::ranges::count(own.arguments, a.name, &Argument::name) > 1)
      refuse(own, "two arguments are called " + a.name + "; give each a name of its own");
    if (a.parts.empty()) refuse(own, a.name + " has no parts");
    if (a.any_number() && (a.parts.size() > 1 || a.parts[0].role != Role::points))
      refuse(own, a.name + ": any number there may be of points alone");
    for (const Part& part : a.parts) {
      if (part.dimension < 1 || part.count < 1) refuse(own, a.name + " has a part without numbers");
      if (part.role == Role::corners && part.count != 2) refuse(own, a.name + ": a box has two corners");
      if (names_points(part.role)) refuse(own, a.name + ": triangles of points cannot be asked for");
      made = made && is_made(part.role);
    }
  }
  if (!made && own.generators.empty()) refuse(own, "frames are not made; give generators of your own");
}

// Coordinates of one dimension, of hard points: beyond three, in parts of three at most.
void fill_any(const FillOf& fill, int dimension, std::span<double> all, Entropy& entropy) {
  const auto stride = static_cast<std::size_t>(dimension);
  for (std::size_t axis = 0; axis < stride;) {
    const std::size_t width = std::min<std::size_t>(stride - axis, 3), points = all.size() / stride;
    std::vector<double> part((width == 1 ? 2 : width) * points);  // numbers alone: the points of a plane, x by x
    fill(width == 3 ? 3 : 2, part, entropy);
    for (std::size_t p = 0; p < points; ++p) {
      for (std::size_t k = 0; k < width; ++k) all[p * stride + axis + k] = part[p * (width == 1 ? 2 : width) + k];
    }
    axis += width;
  }
}

// All numbers of one dimension are filled together: so they are degenerate together.
void arrange(const Kind& shape, Numbers& numbers, Entropy& entropy, const FillOf& fill) {
  numbers.clear();
  for (const Argument& a : shape.arguments) {
    std::size_t count = 1;
    if (a.any_number()) {
      count = a.least + entropy.below(kMorePoints);
      numbers.push_back(static_cast<double>(count));
    }
    numbers.insert(numbers.end(), count * numbers_in(a), 0.0);
  }
  const std::vector<Field> fields = fields_of(shape, numbers);
  std::vector<std::size_t> done;
  for (const Field& first : fields) {
    if (std::ranges::find(done, first.dimension) != done.end()) continue;
    done.push_back(first.dimension);
    std::vector<Field> alike;
    std::ranges::copy_if(fields, std::back_inserter(alike),
                         [&](const Field& f) { return f.dimension == first.dimension; });
    Numbers filled = gathered(numbers, alike);
    fill_any(fill, static_cast<int>(first.dimension), filled, entropy);
    scatter(filled, alike, numbers);
  }
  // A direction leads from the point before it, if there is one of its dimension.
  for (std::size_t i = 1; i < fields.size(); ++i) {
    const Field &from = fields[i - 1], &to = fields[i];
    if (to.role != Role::vector || from.role != Role::points || from.dimension != to.dimension) continue;
    for (std::size_t k = 0; k < to.size(); ++k) {
      const double way = numbers[to.first + k] - numbers[from.first + k % from.dimension];
      if (std::isfinite(way)) numbers[to.first + k] = way;
    }
  }
  put_in_order(shape, numbers);
}

// Between two doubles where the answer differs, the place where it changes from one to the next.
void bisect(const Exact& exact, Numbers& numbers, std::size_t at, double other, Entropy& entropy) {
  const auto answer = [&](double x) {
    numbers[at] = x;
    return exact(numbers).numbers;
  };
  std::int64_t low = place_of(numbers[at]), high = place_of(other);
  const Numbers of_low = answer(double_at(low));
  while (low + 1 < high || high + 1 < low) {
    const std::int64_t middle = low / 2 + high / 2 + (low % 2 + high % 2) / 2;
    (answer(double_at(middle)) == of_low ? low : high) = middle;
  }
  numbers[at] = double_at(entropy.coin() ? high : low);
}

Generator at_change(const Kind& shape, std::vector<Generator> from) {
  const auto make = [shape, from = std::move(from)](Numbers& numbers, Entropy& entropy) {
    from[entropy.below(from.size())].make(numbers, entropy);
    const std::vector<Field> fields = lengths_of(shape, numbers);
    const Numbers before = shape.exact(numbers).numbers;
    for (int tries = 0; tries < 8; ++tries) {
      const Field& f = fields[entropy.below(fields.size())];
      const std::size_t at = f.first + entropy.below(f.size());
      const double old = numbers[at];
      numbers[at] = entropy.coin()
                        ? -old
                        : coordinate_of(static_cast<CoordinateClass>(entropy.below(coordinate_class_count)), entropy);
      const double other = numbers[at];
      const bool differs = flaw_of(shape, numbers).empty() && shape.exact(numbers).numbers != before;
      numbers[at] = old;
      if (differs) return bisect(shape.exact, numbers, at, other, entropy);
    }
  };
  return {"at_change", "one number moved until the answer changes between it and the next double", make};
}

std::string signature_of(const OwnKind& own) {
  std::string text(own.form == AnswerForm::yes_no ? "int f(" : "double f(");
  for (std::size_t i = 0; i < own.arguments.size(); ++i) {
    const Argument& a = own.arguments[i];
    text.append(i == 0 ? "" : ", ").append("const double");
    if (a.any_number()) {
      text.append("* ").append(a.name).append(", size_t ").append(a.name).append("_count");
    } else {
      text.append(" ").append(a.name).append("[").append(std::to_string(numbers_in(a))).append("]");
    }
  }
  return text.append(")");
}

std::string_view what_counts(AnswerForm form) {
  return form == AnswerForm::sign ? "only the sign counts" : form == AnswerForm::yes_no ? "not 0: yes" : "the number";
}

}  // namespace

Kind own_kind(OwnKind own) {
  require_sense(own);
  std::vector<bool> counted;
  bool made = true;
  for (const Argument& a : own.arguments) {
    counted.push_back(a.any_number());
    for (const Part& part : a.parts) made = made && is_made(part.role);
  }
  const OwnCall call = own_call(counted, own.form == AnswerForm::yes_no);
  std::string signature = signature_of(own);
  Kind kind{own.name,
            own.question.empty() ? std::string("what is ").append(own.name).append("?") : own.question,
            std::move(signature),
            own.convention.empty() ? std::string(what_counts(own.form)) : own.convention,
            own.form,
            std::move(own.arguments),
            {},
            call.type,
            own.tolerance,
            call.call,
            std::move(own.exact)};
  if (kind.form == AnswerForm::sign) {
    kind.special = [exact = kind.exact](std::span<const double> numbers) { return exact(numbers).numbers[0] == 0; };
  }
  std::vector<Generator> all;
  if (made) {
    const auto by = [shape = kind](Numbers& numbers, Entropy& entropy, const FillOf& fill) {
      arrange(shape, numbers, entropy, fill);
    };
    all = families_of_cases(own.aim, by);
  }
  std::ranges::move(own.generators, std::back_inserter(all));
  if (kind.form != AnswerForm::number) all.push_back(at_change(kind, all));
  kind.generators = std::move(all);
  return kind;
}

Kind formula_kind(const FormulaShape& shape, std::optional<Degeneracy> aim) {
  OwnKind own{.name = std::string(shape.name), .arguments = {}, .exact = {}, .aim = aim};
  own.question = std::string("which sign has ").append(shape.name).append("?");
  for (std::size_t i = 0; i < shape.arguments.size(); ++i) {
    std::string name = shape.argument_names.empty() ? std::string(1, static_cast<char>('a' + i))
                                                    : std::string(shape.argument_names[i]);
    own.arguments.push_back(points(std::move(name), shape.arguments[i]));
  }
  own.exact = [sign = shape.sign](std::span<const double> numbers) {
    return Answer(static_cast<double>(sign(numbers)));
  };
  return own_kind(std::move(own));
}

}  // namespace plumb::degenerate
