// By how much can the floating-point value of a formula be off when its coordinates are integers below a bound?  A
// number that follows the largest value and the largest error through a formula: zero while integers stay below 2^53.
//
// Laws: |exact| <= largest and |computed - exact| <= error, for integer coordinates of at most the magnitude given;
// `root` is the error without the last rounding, which cannot carry a sign past a double.  root == 0: the sign of the
// computed value is the sign of the exact one.  Proof: docs/proof.md, "Lattices".
// Source: RTCD 11.2, 11.4.
// Cost: none where it is run when compiled.
#pragma once

#include <limits>

#include "plumb/predicates/standard.hpp"

namespace plumb {

struct LatticeError {
  double largest;  // an integer below 2^53, or rounded up
  double error;    // rounded up
  double root;

  /// A coordinate: an integer of at most this magnitude, known exactly.
  static constexpr LatticeError coordinate(double largest) { return {largest, 0, 0}; }

  friend constexpr LatticeError operator+(LatticeError a, LatticeError b) {
    return rounded(a.largest + b.largest, a.error + b.error);
  }
  friend constexpr LatticeError operator-(LatticeError a, LatticeError b) { return a + b; }
  friend constexpr LatticeError operator*(LatticeError a, LatticeError b) {
    if (b.largest + b.error >= 1 && a.largest + a.error >= lost_beyond / (b.largest + b.error)) return lost();
    return rounded(a.largest * b.largest, a.largest * b.error + (b.largest + b.error) * a.error);
  }

 private:
  static constexpr double exact_below = 0x1p53;
  static constexpr double lost_beyond = 0x1p1000;
  static constexpr double slack = 1 + 0x1p-49;  // pays for the roundings of one step's bounds

  // From bounds rounded to nearest, the error not yet counting the operation's own rounding.
  static constexpr LatticeError rounded(double largest, double inherited) {
    if (inherited == 0 && largest < exact_below) return {largest, 0, 0};
    largest *= slack;
    inherited *= slack;
    const double error = (inherited + (largest + inherited) * 0x1p-53) * slack;
    if (largest >= lost_beyond || error >= lost_beyond) return lost();
    return {largest, error, inherited};
  }
  static constexpr LatticeError lost() { return {lost_beyond, lost_beyond, std::numeric_limits<double>::infinity()}; }
};

}  // namespace plumb
