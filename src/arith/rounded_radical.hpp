// Which double is (a + b sqrt(c)) / d, or the root of that?  Rounded once, by integers.
//
// Laws: those of arith/big_rounding.hpp; c >= 0, d > 0.
// Source: integer square roots, of twice as many digits until only one double is left; where the root is rational, the
// quotient itself.
// Cost: some microseconds.
#pragma once

#include "arith/big_rounding.hpp"

namespace plumb {

double rounded_radical(Rounding rounding, const BigDyadic& a, const BigDyadic& b, const BigDyadic& c,
                       const BigDyadic& d);

/// The square root of it, where it is not negative.
double rounded_nested_root(Rounding rounding, const BigDyadic& a, const BigDyadic& b, const BigDyadic& c,
                           const BigDyadic& d);

}  // namespace plumb
