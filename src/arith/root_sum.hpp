// What sign has a sum of square roots, of any number of them, whole multiples each?
//
// Laws: (1) exact.  (2) Equal sums are told as such: roots whose radicands' product is a square are rational multiples of
// one another, and roots no two of which are so are linearly independent over the rationals, so that a sum is zero where
// the coefficients of each kind add up to zero, and only there.  (3) What is not zero is decided by bounds of ever more
// digits, which come to an end.
// A radicand below zero is misuse.
// Source: Besicovitch 1940 (independence of roots); RTCD 11.4.
// Cost: a product of integers for each two kinds of roots, then roots of integers with 64 binary digits and more behind
// the point.  Bounded by n^2 operations on integers as long as the exponents' span.
#pragma once

#include <span>

#include "plumb/arith/big.hpp"

namespace plumb {

struct RootTerm {
  int times;
  BigDyadic radicand;
};

/// The sign is that of the sum of times * sqrt(radicand).
Sign sign_of_root_sum(std::span<const RootTerm> terms);

}  // namespace plumb
