// Is a formula zero because of equal inputs, whatever the rest?  A number that knows only whether it is certainly zero.
//
// Law: certain means that the exact value is zero; the reverse does not hold (a * d - b * c may cancel by value).
// Catches repeated points, and points that share a coordinate, without arithmetic and at every scale.
// Cost: one comparison for each difference of coordinates.
#pragma once

#include "plumb/predicates/standard.hpp"

namespace plumb {

struct StructuralZero {
  struct Input {
    double value;
  };

  bool certain;

  constexpr explicit StructuralZero(bool zero) : certain(zero) {}
  constexpr StructuralZero(Input x) : certain(x.value == 0) {}  // NOLINT: mixes as an intermediate value

  friend constexpr StructuralZero operator-(Input a, Input b) { return StructuralZero{a.value == b.value}; }
  friend constexpr StructuralZero operator+(Input a, Input b) { return StructuralZero{a.value == -b.value}; }
  // Bitwise: these tests are too cheap and too unpredictable to branch on.
  friend constexpr StructuralZero operator+(StructuralZero a, StructuralZero b) {
    return StructuralZero{(a.certain & b.certain) != 0};
  }
  friend constexpr StructuralZero operator-(StructuralZero a, StructuralZero b) { return a + b; }
  friend constexpr StructuralZero operator*(StructuralZero a, StructuralZero b) {
    return StructuralZero{(a.certain | b.certain) != 0};
  }
};

}  // namespace plumb
