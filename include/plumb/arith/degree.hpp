// How many bits does a formula's exact value need?  A number that counts, when compiled.
//
// Law: with |coordinate| < 2^b, every intermediate value's magnitude is below 2^(its BitLength).
// Source: RTCD 11.2.
// Cost: none at run time.
#pragma once

#include "plumb/predicates/standard.hpp"

namespace plumb {

struct BitLength {
  int bits;

  friend constexpr BitLength operator+(BitLength a, BitLength b) { return {(a.bits > b.bits ? a.bits : b.bits) + 1}; }
  friend constexpr BitLength operator-(BitLength a, BitLength b) { return a + b; }
  friend constexpr BitLength operator*(BitLength a, BitLength b) { return {a.bits + b.bits}; }
};

}  // namespace plumb
