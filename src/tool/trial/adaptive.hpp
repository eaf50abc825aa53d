// How do adaptive expansions take a sign, as the literature has them?  Four stages, each adding what the last left out.
//
// Stage A is the plain value against its bound; B takes the rounded differences exactly; C adds the first-order effect
// of what the differences lost; D is the whole value as an expansion.  The constants of the bounds are those published
// with the method.
// Laws: exact while nothing overflows or underflows, which the published method does not claim either; beyond that it
// is on trial here, and decides nothing of ours.
// Source: Shewchuk 1997, "Adaptive precision floating-point arithmetic and fast robust geometric predicates", stated
// here over any formula of differences.
// Cost: A twice the plain formula, B to D hundreds to thousands of ns.
#pragma once

#include "plumb/arith/filtered.hpp"
#include "plumb/certify/formula.hpp"
#include "plumb/predicates/in_sphere.hpp"
#include "plumb/predicates/orient.hpp"
#include "tool/trial/expansion.hpp"

namespace plumb::tool::trial {

/// Of the errors after stages A, B and C, in units of 2^-53, 2^-53 and 2^-106 of the sum of absolute terms.
struct StageBounds {
  double a, b, c;
};
template <class F>
inline constexpr StageBounds published_bounds = [] {
  constexpr double e = 0x1p-53;
  if (F::name == predicates::Orient2d::name)
    return StageBounds{(3 + 16 * e) * e, (2 + 12 * e) * e, (9 + 64 * e) * e * e};
  if (F::name == predicates::Orient3d::name)
    return StageBounds{(7 + 56 * e) * e, (3 + 28 * e) * e, (26 + 288 * e) * e * e};
  if (F::name == predicates::InCircle::name)
    return StageBounds{(10 + 96 * e) * e, (4 + 48 * e) * e, (44 + 576 * e) * e * e};
  return StageBounds{(16 + 224 * e) * e, (5 + 72 * e) * e, (71 + 1408 * e) * e * e};
}();

/// A value and the sum of the absolute values of its terms.
struct Summed {
  struct Input {
    double x;
    friend Summed operator-(Input a, Input b) { return {a.x - b.x, magnitude_of(a.x - b.x)}; }
  };
  double value, magnitude;
  friend Summed operator+(Summed a, Summed b) { return {a.value + b.value, a.magnitude + b.magnitude}; }
  friend Summed operator-(Summed a, Summed b) { return {a.value - b.value, a.magnitude + b.magnitude}; }
  friend Summed operator*(Summed a, Summed b) { return {a.value * b.value, a.magnitude * b.magnitude}; }
};

/// A value and its change when every difference is changed by what its rounding lost; whether any lost anything.
struct Corrected {
  struct Input {
    double x;
    friend Corrected operator-(Input a, Input b) {
      const Rounded d = two_sum(a.x, -b.x);
      return {d.value, d.error, d.error != 0};
    }
  };
  double value, change;
  bool lost;
  friend Corrected operator+(Corrected a, Corrected b) {
    return {a.value + b.value, a.change + b.change, a.lost || b.lost};
  }
  friend Corrected operator-(Corrected a, Corrected b) {
    return {a.value - b.value, a.change - b.change, a.lost || b.lost};
  }
  friend Corrected operator*(Corrected a, Corrected b) {
    return {a.value * b.value, a.value * b.change + a.change * b.value, a.lost || b.lost};
  }
};

/// Coordinates whose differences enter an expansion rounded, and exactly.
struct RoundedInput {
  double x;
  friend Expansion operator-(RoundedInput a, RoundedInput b) { return Expansion(a.x - b.x); }
};
struct ExactInput {
  double x;
  friend Expansion operator-(ExactInput a, ExactInput b) { return Expansion::difference(a.x, b.x); }
};

template <Formula F>
[[gnu::noinline]] Sign adaptive_sign_beyond(const Coordinates<F>& p, double magnitude) {
  constexpr StageBounds bounds = published_bounds<F>;
  constexpr double of_result = (3 + 8 * 0x1p-53) * 0x1p-53;
  const auto sure = [](double value, double bound) { return value >= bound || -value >= bound; };
  Expansion::reset();
  const double b = evaluate<F>([&](std::size_t i) { return RoundedInput{p[i]}; }).estimate();
  if (sure(b, bounds.b * magnitude)) return sign_of_number(b);
  const Corrected first = evaluate<F>([&](std::size_t i) { return Corrected::Input{p[i]}; });
  if (!first.lost) return sign_of_number(b);
  const double c = b + first.change;
  if (sure(c, bounds.c * magnitude + of_result * magnitude_of(b))) return sign_of_number(c);
  Expansion::reset();
  return evaluate<F>([&](std::size_t i) { return ExactInput{p[i]}; }).sign();
}

template <Formula F>
Sign adaptive_sign(const Coordinates<F>& p) {
  const Summed a = evaluate<F>([&](std::size_t i) { return Summed::Input{p[i]}; });
  const double bound = published_bounds<F>.a * a.magnitude;
  if (a.value > bound || -a.value > bound) return sign_of_number(a.value);
  return adaptive_sign_beyond<F>(p, a.magnitude);
}

}  // namespace plumb::tool::trial
