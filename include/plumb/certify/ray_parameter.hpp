// Ray cast: what is the exact parameter at which a ray hits?  A rational number, less or more the root of one.
//
// Laws: the value is base - sqrt(square), or base + sqrt(square) of a `greater` root, by which a cone may be entered
// and a ball is left; square is never negative, and zero for what is flat.  Comparison is that of real arithmetic; equal numbers are equal however they were made.
// Source: RTCD 5.3; signs of radicals by repeated squaring (predicates/radical.hpp).
// Cost: some microseconds.
#pragma once

#include <compare>

#include "plumb/arith/rational.hpp"

namespace plumb {

struct RayParameter {
  Rational base;
  Rational square{0.0};
  bool greater = false;

  [[nodiscard]] Sign sign() const;
  [[nodiscard]] double rounded(Rounding rounding = Rounding::nearest) const;

  friend std::strong_ordering operator<=>(const RayParameter& a, const RayParameter& b);
  friend bool operator==(const RayParameter& a, const RayParameter& b) { return (a <=> b) == 0; }
};

}  // namespace plumb
