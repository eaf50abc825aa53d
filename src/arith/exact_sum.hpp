// Which double is a sum of any length, or a quotient of two?  Pairs of doubles first, integers where they leave a
// doubt.
//
// A sum is a lambda that takes a maker of numbers, number(double), and gives a number of that kind:
//   nearest([&](auto number) { return number(a) * number(b) + ...; })
// Laws: (1) it uses + - * only; (2) the exact value rounded once, to nearest.
// Source: Ziv 1991.
// Cost: twenty to forty operations a term, GMP in doubt.
#pragma once

#include <array>

#include "arith/big_rounding.hpp"
#include "plumb/arith/ball.hpp"

namespace plumb::arith::exact_sum {

inline constexpr auto to_ball = [](double x) { return Ball{x}; };
inline constexpr auto to_big = [](double x) { return BigDyadic(x); };

/// The maker's kind of number.
template <class Maker>
using Number = decltype(std::declval<const Maker&>()(0.0));

template <class Sum>
double nearest(const Sum& sum, double divisor = 1) {
  const Ball quick = sum(to_ball);
  if (const auto x = (divisor == 1 ? quick : quotient(quick, Ball{divisor})).nearest()) return *x;
  return rounded_quotient(Rounding::nearest, sum(to_big), BigDyadic(divisor));
}

/// The square root of the sum, divided by the divisor.
template <class Sum>
double nearest_root(const Sum& sum, double divisor = 1) {
  const Ball quick = root(sum(to_ball));
  if (const auto x = (divisor == 1 ? quick : quotient(quick, Ball{divisor})).nearest()) return *x;
  return rounded_root(Rounding::nearest, sum(to_big), BigDyadic(divisor) * BigDyadic(divisor));
}

template <class Sum>
Sign sign(const Sum& sum) {
  const Unsure<Sign> quick = sum(to_ball).sign();
  return quick.certain() ? quick.value() : sum(to_big).sign();
}

/// The quotients of N sums by one: lambdas give an array of N + 1 numbers, the divisor last.  `degenerate` where the
/// divisor is exactly zero.
template <std::size_t N>
struct Quotients {
  bool degenerate = false;
  std::array<double, N> value{};
};

template <std::size_t N, class Sums>
Quotients<N> nearest_quotients(const Sums& sums) {
  Quotients<N> found;
  const std::array<Ball, N + 1> quick = sums(to_ball);
  bool sure = true;
  for (std::size_t i = 0; i < N && sure; ++i) {
    const auto x = quotient(quick[i], quick[N]).nearest();
    sure = x.has_value();
    if (sure) found.value[i] = *x;
  }
  if (sure) return found;
  const std::array<BigDyadic, N + 1> exact = sums(to_big);
  found.degenerate = exact[N].sign() == Sign::zero;
  for (std::size_t i = 0; i < N && !found.degenerate; ++i)
    found.value[i] = rounded_quotient(Rounding::nearest, exact[i], exact[N]);
  return found;
}

}  // namespace plumb::arith::exact_sum
