// One exact number in the form of another: a Rational, as answers tell it, or GMP's, as computations take it.
//
// Laws: the same number.
// Source: none.
// Cost: a copy; none of what is held already.
#pragma once

#include <utility>

#include "plumb/arith/big.hpp"
#include "plumb/arith/rational.hpp"

namespace plumb {

inline Rational exact_number(mpq_class x) { return Rational(BigRational{std::move(x)}); }
inline Rational exact_number(const BigDyadic& x) { return Rational(big_rational(x)); }
inline const Rational& exact_number(const Rational& x) { return x; }

inline mpq_class gmp_number(const BigDyadic& x) { return big_rational(x).value; }
inline const mpq_class& gmp_number(const Rational& x) { return x.value().value; }

}  // namespace plumb
