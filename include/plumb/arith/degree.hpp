// Is a formula homogeneous, and how many bits does its exact value need?  Numbers that count, when compiled.
//
// Laws: Degree adds only equal degrees, so an inhomogeneous formula does not compile.  A homogeneous formula keeps its
// sign when all coordinates are multiplied by a power of two: that is why integers may stand for doubles.
// With |coordinate| < 2^b, every intermediate value's magnitude is below 2^(its BitLength).
// Source: RTCD 11.2; cost: none at run time.
#pragma once

#include <stdexcept>

namespace plumb {

struct Degree {
  struct Input {};

  int degree;

  constexpr explicit Degree(int d) : degree(d) {}
  constexpr Degree(Input) : Degree(1) {}  // NOLINT: a coordinate has degree 1

  friend constexpr Degree operator+(Degree a, Degree b) {
    if (a.degree != b.degree) throw std::logic_error("a formula adds terms of unequal degree");
    return a;
  }
  friend constexpr Degree operator-(Degree a, Degree b) { return a + b; }
  friend constexpr Degree operator*(Degree a, Degree b) { return Degree{a.degree + b.degree}; }
};

struct BitLength {
  int bits;

  friend constexpr BitLength operator+(BitLength a, BitLength b) { return {(a.bits > b.bits ? a.bits : b.bits) + 1}; }
  friend constexpr BitLength operator-(BitLength a, BitLength b) { return a + b; }
  friend constexpr BitLength operator*(BitLength a, BitLength b) { return {a.bits + b.bits}; }
};

}  // namespace plumb
