// How large can the magnitude be, given the largest difference per axis?  Filter B: the magnitude of filter A with
// every difference replaced by the largest one of its axis.
//
// Laws: rounding is monotone, so the magnitude over the largest differences is never below that of the terms
// themselves; the same constant of Bound therefore serves both filters.  The largest differences start from a floor
// whose power in the formula's degree is a normal number: no product's magnitude underflows, and the guards of filter A
// are not needed.
// Equal terms of the magnitude are computed once, and known bounds of a scene turn it into a constant.
// Source: RTCD 11.2; the maxima are those of semi-static filters.
// Cost: one |x| and one maximum for each difference.
#pragma once

#include <array>
#include <cstddef>

#include "plumb/arith/filtered.hpp"

namespace plumb {

/// Upper bound of Filtered's magnitude; the input is the largest difference of the coordinate's axis.
struct LargestMagnitude {
  struct Input {
    double largest;
  };

  double magnitude;

  constexpr explicit LargestMagnitude(double m) : magnitude(m) {}
  constexpr LargestMagnitude(Input x) : magnitude(x.largest) {}  // NOLINT: mixes as an intermediate value

  friend constexpr LargestMagnitude operator-(Input a, Input) { return LargestMagnitude{a}; }
  friend constexpr LargestMagnitude operator+(Input a, Input) { return LargestMagnitude{a}; }
  friend constexpr LargestMagnitude operator+(LargestMagnitude a, LargestMagnitude b) {
    return LargestMagnitude{a.magnitude + b.magnitude};
  }
  friend constexpr LargestMagnitude operator-(LargestMagnitude a, LargestMagnitude b) { return a + b; }
  friend constexpr LargestMagnitude operator*(LargestMagnitude a, LargestMagnitude b) {
    return LargestMagnitude{a.magnitude * b.magnitude};
  }
};

/// Degree in each axis: when every term of a formula has the same, its magnitude is one product of the largest
/// differences times the number of terms.
template <std::size_t Dimension>
struct AxisDegrees {
  struct Input {
    std::size_t axis;
  };

  std::array<int, Dimension> degree{};
  bool equal_terms = true;

  constexpr AxisDegrees() = default;
  constexpr AxisDegrees(Input x) { degree[x.axis] = 1; }  // NOLINT: mixes as an intermediate value

  friend constexpr AxisDegrees operator+(AxisDegrees a, AxisDegrees b) {
    a.equal_terms = a.equal_terms && b.equal_terms && a.degree == b.degree;
    return a;
  }
  friend constexpr AxisDegrees operator-(AxisDegrees a, AxisDegrees b) { return a + b; }
  friend constexpr AxisDegrees operator*(AxisDegrees a, AxisDegrees b) {
    for (std::size_t i = 0; i < Dimension; ++i) a.degree[i] += b.degree[i];
    a.equal_terms = a.equal_terms && b.equal_terms;
    return a;
  }
};

}  // namespace plumb
