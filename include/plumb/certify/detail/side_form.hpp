// Which part of a formula does not depend on the point that is asked about?  A formula taken apart when it is compiled:
// the sign for many query points costs a few products each, once the minors of the given points are known.
//
// The formula is not stated again.  Its tape is read with the query point in the first place, where nothing else is a
// difference to it; an even permutation brings it there, under which the sign stays (law 1 of plumb/predicates.hpp).
// Then every number on the tape depends on the given points alone, or on the query point and the pivot (the point in
// the last place) alone, such as their differences and the squares of these, or is linear in the latter.  The result is
//
//   variable[0] * coefficient[0] + variable[1] * coefficient[1] + ...
//
// with coefficients that the given points yield: the minors.
//
// Laws: the form has the value of the formula in exact arithmetic, for all inputs; its filter constant is derived from
// its own operations, as in certify/formula.hpp.  A formula that is not linear in this sense does not compile.
// Source: cofactor expansion, RTCD 3.1.3; docs/batches.md, "One against many".
// Cost: compile time only.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "plumb/arith/bound.hpp"
#include "plumb/certify/formula.hpp"

namespace plumb::certify::side {

template <Formula F>
inline constexpr auto dimension = static_cast<std::size_t>(F::dimension);
template <Formula F>
inline constexpr auto points = static_cast<std::size_t>(F::points);

/// Whose point is taken to a place of the formula: first and last are swapped, and two others, which makes it even.
template <Formula F>
constexpr std::size_t point_at(std::size_t place) {
  static_assert(points<F> >= 3);
  std::array<std::size_t, points<F>> at{};
  for (std::size_t i = 0; i < at.size(); ++i) at[i] = i;
  const auto swap = [&at](std::size_t i, std::size_t j) {
    const std::size_t kept = at[i];
    at[i] = at[j];
    at[j] = kept;
  };
  swap(0, at.size() - 1);
  swap(1, 2);
  return at[place];
}

/// The point to which all others are differences.
template <Formula F>
inline constexpr std::size_t pivot = point_at<F>(points<F> - 1);

inline constexpr std::size_t most_variables = 6, most_instructions = 512;

/// Throws std::logic_error; where the compiler takes a formula apart, the reason stands in the call that it refuses.
[[noreturn]] void throw_no_form(const char* reason);

struct Coefficient {
  bool present = false, negative = false;
  std::uint16_t number = 0;  // on the tape of the fixed points
};

/// Fixed: inputs are all coordinates as the caller orders them, results follow.  Query: inputs are the differences of
/// the query point to the pivot, one for each axis, results follow.
struct Form {
  certify::tape::Tape<most_instructions> fixed, query;
  std::array<std::uint16_t, most_variables> variable{};  // numbers on the tape of the query
  std::array<Coefficient, most_variables> coefficient{};
  std::size_t variables = 0;
};

/// Takes the formula's tape apart, one instruction after the other.
class Separation {
 public:
  constexpr Separation(std::size_t arity, std::size_t dimension, std::size_t pivot) : dimension_(dimension) {
    form_.fixed.arity = arity;
    form_.query.arity = dimension;
    pivot_ = pivot;
  }

  enum class Role { fixed, query_input, query, mixed };
  struct Number {
    Role role = Role::fixed;
    std::uint16_t index = 0;  // fixed: on that tape; query_input: the axis; query: on the query's tape
    std::array<Coefficient, most_variables> terms{};
  };

  [[nodiscard]] constexpr Number combined(char operation, const Number& l, const Number& r) {
    using enum Role;
    const bool times = operation == '*';
    if (l.role == fixed && r.role == fixed) return {fixed, form_.fixed.write(operation, l.index, r.index), {}};
    if (l.role == query_input && r.role == fixed && operation == '-' && r.index == pivot_ * dimension_ + l.index) {
      return {query, l.index, {}};
    }
    if (l.role == query && r.role == query) return {query, form_.query.write(operation, l.index, r.index), {}};
    if (l.role == query && r.role == fixed && times) return product(l.index, r.index);
    if (l.role == fixed && r.role == query && times) return product(r.index, l.index);
    if (l.role == mixed && r.role == fixed && times) return scaled(l, r.index);
    if (l.role == fixed && r.role == mixed && times) return scaled(r, l.index);
    if (l.role == mixed && r.role == mixed && !times) return sum(l, r, operation == '-');
    throw_no_form("a formula is not linear in its query point and the squares of that");
  }

  constexpr Form finished(const Number& result) {
    if (result.role != Role::mixed) throw_no_form("a formula does not ask about its query point");
    form_.coefficient = result.terms;
    return form_;
  }

 private:
  constexpr std::size_t variable(std::uint16_t query_number) {
    for (std::size_t v = 0; v < form_.variables; ++v) {
      if (form_.variable[v] == query_number) return v;
    }
    if (form_.variables == most_variables) throw_no_form("a formula has too many variables");
    form_.variable[form_.variables] = query_number;
    return form_.variables++;
  }

  constexpr Number product(std::uint16_t query_number, std::uint16_t fixed_number) {
    Number n{Role::mixed, 0, {}};
    n.terms[variable(query_number)] = {true, false, fixed_number};
    return n;
  }

  constexpr Number scaled(Number n, std::uint16_t by) {
    for (Coefficient& c : n.terms) {
      if (c.present) c.number = form_.fixed.write('*', c.number, by);
    }
    return n;
  }

  constexpr Number sum(Number l, const Number& r, bool minus) {
    for (std::size_t v = 0; v < most_variables; ++v) {
      Coefficient& a = l.terms[v];
      Coefficient b = r.terms[v];
      if (!b.present) continue;
      if (minus) b.negative = !b.negative;
      if (!a.present) {
        a = b;
      } else if (a.negative == b.negative) {
        a.number = form_.fixed.write('+', a.number, b.number);
      } else {
        const std::uint16_t plus = a.negative ? b.number : a.number, less = a.negative ? a.number : b.number;
        a = {true, false, form_.fixed.write('-', plus, less)};
      }
    }
    return l;
  }

  Form form_;
  std::size_t dimension_, pivot_ = 0;
};

template <Formula F>
inline constexpr Form form_of = [] {
  constexpr std::size_t dim = dimension<F>, size = certify::tape::of<F>.size;
  using Role = Separation::Role;
  Separation separation(arity<F>, dim, pivot<F>);
  std::array<Separation::Number, arity<F> + size> number{};
  for (std::size_t i = 0; i < arity<F>; ++i) {
    const bool of_query = i < dim;
    number[i].role = of_query ? Role::query_input : Role::fixed;
    number[i].index = static_cast<std::uint16_t>(of_query ? i : point_at<F>(i / dim) * dim + i % dim);
  }
  for (std::size_t i = 0; i < size; ++i) {
    const certify::tape::Instruction in = certify::tape::of<F>.instructions[i];
    number[arity<F> + i] = separation.combined(in.operation, number[in.left], number[in.right]);
  }
  return separation.finished(number[arity<F> + size - 1]);
}();

/// As filter_constant of certify/formula.hpp, for the form's own operations.
template <Formula F>
inline constexpr double constant = [] {
  const auto run = [](const auto& tape, std::array<Bound, arity<F> + most_instructions>& bound) {
    for (std::size_t i = 0; i < tape.size; ++i) {
      const certify::tape::Instruction in = tape.instructions[i];
      const bool of_inputs = in.left < arity<F> && in.right < arity<F> && tape.arity == arity<F>;
      const Bound l = bound[in.left], r = bound[in.right];
      bound[tape.arity + i] = of_inputs ? Bound{Bound::eps, 0} : in.operation == '*' ? l * r : l + r;
    }
  };
  constexpr const Form& form = form_of<F>;
  const auto filled = [](Bound b) {
    std::array<Bound, arity<F> + most_instructions> all = []<std::size_t... I>(Bound x, std::index_sequence<I...>) {
      return std::array<Bound, sizeof...(I)>{((void)I, x)...};
    }
    (b, std::make_index_sequence<arity<F> + most_instructions>());
    return all;
  };
  auto fixed = filled(Bound::Input{}), query = filled(Bound{Bound::eps, 0});
  run(form.fixed, fixed);
  run(form.query, query);
  Bound sum = Bound::Input{};
  for (std::size_t v = 0; v < form.variables; ++v) {
    const Bound term = query[form.variable[v]] * fixed[form.coefficient[v].number];
    sum = v == 0 ? term : sum + term;
  }
  return static_cast<double>(sum.root + 2) * 0x1p-85;
}();

}  // namespace plumb::certify::side
