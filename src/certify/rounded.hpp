// Which double is a polynomial's value, a quotient of two, or its root?  Rounded once, to nearest or outward.
//
//   rounded_root(Rounding::up, SquaredDistance{}, a, b)
//
// Formulas and arguments are those of sign_of (formulas or lambdas); numerator and denominator take the same arguments.
// Laws: (1) the double that the rounding names, of the exact value.  (2) Infinite where that is beyond all doubles and
// the rounding leads there; zero is never -0.  (3) The denominator must not be zero, nor the radicand negative: ask
// their signs before.  A coordinate that is NaN or infinite throws NonFinite.
// Source: Ziv 1991; RTCD 11.4.
// Cost: pairs of doubles, some 20 ns; about 1 us where they leave a choice.
#pragma once

#include <optional>

#include "plumb/arith/ball.hpp"
#include "plumb/certify/sign_of.hpp"

namespace plumb {

namespace certify::rounding {

enum class Form : unsigned char { value, quotient, root };

/// By integers: numerator / denominator, or its root.
double by_integers(Rounding rounding, Form form, certify::tape::Program numerator, certify::tape::Program denominator,
                   std::span<const double> coordinates);

/// A denominator for values, and for roots of them.
struct One {
  static constexpr std::string_view name = "one";
};

template <class N, class D, class... Arguments>
[[gnu::noinline]] double exactly(Rounding rounding, Form form, const Arguments&... arguments) {
  using F = typename FormulaOf<N, Arguments...>::Type;
  const Coordinates<F> p = coordinates_of<F>(arguments...);
  require_finite<F>(p);
  if constexpr (std::is_same_v<D, One>) {
    return by_integers(rounding, form, certify::tape::program<F>(), {}, p);
  } else {
    return by_integers(rounding, form, certify::tape::program<F>(),
                       certify::tape::program<typename FormulaOf<D, Arguments...>::Type>(), p);
  }
}

template <class F>
constexpr Ball ball(const Coordinates<F>& p) {
  return evaluate<F>([&](std::size_t i) { return Ball{p[i]}; });
}

template <Form form, class N, class D, class... Arguments>
double rounded(Rounding rounding, const Arguments&... arguments) {
  static_assert(accepts<N, Arguments...>());
  using F = typename FormulaOf<N, Arguments...>::Type;
  static_assert(is_polynomial<F>());
  if constexpr (std::is_same_v<D, One>) {
    static_assert(use_all_coordinates<F>());
  } else {
    static_assert(accepts<D, Arguments...>());
    static_assert(use_all_coordinates<F, typename FormulaOf<D, Arguments...>::Type>());
  }
  const Coordinates<F> p = coordinates_of<F>(arguments...);
  Ball b = ball<F>(p);
  if constexpr (!std::is_same_v<D, One>) b = quotient(b, ball<typename FormulaOf<D, Arguments...>::Type>(p));
  if constexpr (form == Form::root) b = root(b);
  if (const std::optional<double> quick = b.rounded(rounding)) [[likely]]
    return *quick;
  return exactly<N, D>(rounding, form, arguments...);
}

}  // namespace certify::rounding

template <class N, class... Arguments>
double rounded_value(Rounding rounding, N, const Arguments&... arguments) {
  return certify::rounding::rounded<certify::rounding::Form::value, N, certify::rounding::One>(rounding, arguments...);
}

template <class N, class D, class... Arguments>
double rounded_quotient(Rounding rounding, N, D, const Arguments&... arguments) {
  return certify::rounding::rounded<certify::rounding::Form::quotient, N, D>(rounding, arguments...);
}

/// The square root of N, or of N / D.
template <class N, class... Arguments>
double rounded_root(Rounding rounding, N, const Arguments&... arguments) {
  return certify::rounding::rounded<certify::rounding::Form::root, N, certify::rounding::One>(rounding, arguments...);
}
template <class N, class D, class... Arguments>
double rounded_root_of_quotient(Rounding rounding, N, D, const Arguments&... arguments) {
  return certify::rounding::rounded<certify::rounding::Form::root, N, D>(rounding, arguments...);
}

}  // namespace plumb
