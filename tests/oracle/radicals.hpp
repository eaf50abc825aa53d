// What sign has a + b sqrt(c) + d sqrt(e)?  Two judges, neither of which uses our polynomials.
//
// digits_sign computes the roots as integers of so many digits that what is closer to zero must be zero: with the terms
// scaled to integers and M a bound of |a| + |b| sqrt(c) + |d| sqrt(e), the number is an algebraic integer with at most
// three other conjugates, all below M, whose product with it is an integer: it is zero or at least M^-3.
// cgal_sign squares twice, as CGAL's Sqrt_extension does.
// Source: root separation is classical (Burnikel, Fleischer, Mehlhorn, Schirra 2000).
// Cost: 10 us to 1 ms.
#pragma once

#include <gmpxx.h>

#include <array>

#include "plumb/arith/sign.hpp"

namespace plumb::oracle {

/// a, b, c, d, e; c and e not negative.
using Radicals = std::array<mpq_class, 5>;

Sign digits_sign(const Radicals& r);
Sign cgal_sign(const Radicals& r);

}  // namespace plumb::oracle
