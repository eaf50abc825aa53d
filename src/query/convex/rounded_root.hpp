// Which double is base + share * sqrt(square), of rationals?
//
// Laws: rounded once; the square is not negative; never -0.
// Source: arith/rounded_radical.hpp.
// Cost: some microseconds.
#pragma once

#include <gmpxx.h>

#include "arith/rounded_radical.hpp"

namespace plumb::query {

inline double rounded_with_root(Rounding rounding, const mpq_class& base, const mpq_class& share,
                                const mpq_class& square) {
  const mpz_class root = square.get_num() * square.get_den();  // of (share / den) sqrt(num den)
  const mpq_class over = share / square.get_den();
  const mpz_class scale = base.get_den() * over.get_den(), at = base.get_num() * over.get_den(),
                  by = over.get_num() * base.get_den();
  return rounded_radical(rounding, BigDyadic(at), BigDyadic(by), BigDyadic(root), BigDyadic(scale)) + 0.0;
}

}  // namespace plumb::query
