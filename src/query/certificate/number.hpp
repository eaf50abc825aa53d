// Rational numbers as GMP computes with them, and back.
//
// Source: none.
// Cost: a copy, back.
#pragma once

#include "plumb/arith/big.hpp"
#include "plumb/arith/rational.hpp"

namespace plumb::query {

inline const mpq_class& number(const Rational& r) { return r.value().value; }
inline Rational rational(mpq_class x) { return Rational(BigRational{std::move(x)}); }

}  // namespace plumb::query
