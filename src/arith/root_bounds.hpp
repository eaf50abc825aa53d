// Between which dyadic numbers lie a root and pi?  For sums of such terms, all of one sign, where pairs of doubles
// leave a doubt.
//
// Laws: lower <= exact <= upper, and they differ by less than 2^-98 of the root, 2^-210 of pi; exact squares of 53 bits
// have exact roots.
// Source: one Newton step; the digits of pi are tested by Machin's formula.
// Cost: some 3 us a root.
#pragma once

#include <cstddef>

#include "arith/exact_sum.hpp"

namespace plumb {

struct BigBounds {
  BigDyadic lower, upper;

  friend BigBounds operator+(const BigBounds& a, const BigBounds& b) { return {a.lower + b.lower, a.upper + b.upper}; }
};

/// Of the root of what is not negative.
BigBounds root_bounds(const BigDyadic& x);

BigBounds pi_bounds();
Ball pi_ball();

/// As a pair of doubles; of infinite radius where doubles do not reach.
Ball ball_around(const BigBounds& bounds);

namespace arith::exact_sum {

/// formula(number, pi, root...) / divisor, of terms that are not negative: within 1 ulp, and nearest but for rare
/// doubt.
template <class Formula, class... Radicands>
double nearly_nearest(const Formula& formula, double divisor, const Radicands&... radicands) {
  const Ball quick = formula(to_ball, pi_ball(), root(radicands(to_ball))...);
  if (const auto x = quotient(quick, Ball{divisor}).nearest()) return *x;
  return rounded_quotient(Rounding::nearest,
                          formula(to_big, pi_bounds().lower, root_bounds(radicands(to_big)).lower...),
                          BigDyadic(divisor));
}

/// formula(number, pi, root...) / divisor(number, root...), both sums of terms that are not negative; likewise.
template <class Formula, class Divisor, class... Radicands>
double nearly_nearest_quotient(const Formula& formula, const Divisor& divisor, const Radicands&... radicands) {
  const Ball quick =
      quotient(formula(to_ball, pi_ball(), root(radicands(to_ball))...), divisor(to_ball, root(radicands(to_ball))...));
  if (const auto x = quick.nearest()) return *x;
  return rounded_quotient(Rounding::nearest,
                          formula(to_big, pi_bounds().lower, root_bounds(radicands(to_big)).lower...),
                          divisor(to_big, root_bounds(radicands(to_big)).lower...));
}

/// The sum of the roots of radicand(number, i) for i < count, divided by a power of two; likewise.
template <class Radicand>
double sum_of_roots(std::size_t count, const Radicand& radicand, double divisor) {
  Ball sum{0.0};
  BigBounds rest;  // of roots that pairs of doubles cannot take
  for (std::size_t i = 0; i < count; ++i) {
    const Ball term = root(radicand(to_ball, i));
    if (term.radius < Ball::infinity) {
      sum = sum + term;
    } else {
      rest = rest + root_bounds(radicand(to_big, i));
    }
  }
  sum = sum + ball_around(rest);
  if (const auto x = quotient(sum, Ball{divisor}).nearest()) return *x;
  BigDyadic all;
  for (std::size_t i = 0; i < count; ++i) all = all + root_bounds(radicand(to_big, i)).lower;
  return rounded_quotient(Rounding::nearest, all, BigDyadic(divisor));
}

}  // namespace arith::exact_sum
}  // namespace plumb
