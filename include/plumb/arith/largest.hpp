// How large can the magnitude be, given the largest difference per axis?  Filter B: the magnitude of filter A with
// every difference replaced by the largest one of its axis.
//
// Law: rounding is monotone, so the magnitude over the largest differences is never below Filtered's own; the same
// constant of Bound therefore serves both filters.  The magnitude needs no per-term absolute values and its equal
// subterms are computed once; known bounds of a scene turn it into a constant (semi-static filter).
// Source: RTCD 11.2; the maxima are those of semi-static filters.  Cost: one |x| and one maximum per difference.
#pragma once

#include "plumb/arith/filtered.hpp"

namespace plumb {

/// Plain value; every difference of coordinates also raises the largest difference of its axis.
struct Watched {
  struct Input {
    double value;
    double* largest;
  };

  double value;

  constexpr explicit Watched(double v) : value(v) {}
  constexpr Watched(Input x) : value(x.value) { raise(x); }  // NOLINT: a coordinate by itself counts as a difference

  static constexpr void raise(Input x) {
    const double m = magnitude_of(x.value);
    *x.largest = m > *x.largest ? m : *x.largest;  // a NaN is not kept here: it ends in the value
  }
  friend constexpr Watched operator-(Input a, Input b) { return Watched{Input{a.value - b.value, a.largest}}; }
  friend constexpr Watched operator+(Input a, Input b) { return Watched{Input{a.value + b.value, a.largest}}; }
  friend constexpr Watched operator+(Watched a, Watched b) { return Watched{a.value + b.value}; }
  friend constexpr Watched operator-(Watched a, Watched b) { return Watched{a.value - b.value}; }
  friend constexpr Watched operator*(Watched a, Watched b) { return Watched{a.value * b.value}; }
};

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
    return LargestMagnitude{a.magnitude * b.magnitude + underflow_guard};
  }
};

}  // namespace plumb
