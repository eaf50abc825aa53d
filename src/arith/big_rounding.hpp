// Which double is the quotient of two integers, or its root?  The end of every construction that pairs of doubles leave
// in doubt.
//
// Laws: rounded once, as asked; zero only for zero, where the rounding allows it, never -0; beyond the largest double
// the result is infinite, or the largest double where the rounding goes toward zero.
// Only .cpp files include this header, as they do arith/big.hpp.
// Source: IEEE 754-2019, 4.3; GMP 6.2 manual.
// Cost: an integer division, below 1 us for the degrees in use.
#pragma once

#include "plumb/arith/big.hpp"
#include "plumb/arith/rounding.hpp"

namespace plumb {

/// x.
double rounded(Rounding rounding, const BigDyadic& x);
double rounded(Rounding rounding, const mpq_class& x);

/// n / d, for d != 0.
double rounded_quotient(Rounding rounding, const BigDyadic& n, const BigDyadic& d);

/// The square root of n / d, for d != 0 and n / d >= 0.
double rounded_root(Rounding rounding, const BigDyadic& n, const BigDyadic& d);

}  // namespace plumb
