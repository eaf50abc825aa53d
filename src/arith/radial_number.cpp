#include "arith/radial_number.hpp"

#include "arith/rounded_radical.hpp"

namespace plumb::arith::radial {

double rounded_exactly(Rounding rounding, const Parts<BigDyadic>& p) {
  if (p.w.sign() == Sign::zero) return rounded_quotient(rounding, p.k, p.n);
  return rounded_radical(rounding, p.k * p.d, p.w, p.d, p.d * p.n);
}

}  // namespace plumb::arith::radial
