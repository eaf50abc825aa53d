// Which double is (K + W / sqrt(D)) / N?  The numbers of round shapes: pairs of doubles first, integers where they leave a
// doubt.
//
// Laws: the exact value rounded once, as asked; infinite beyond all doubles where the rounding leads there; never -0.
// Source: Ziv 1991; integer roots (arith/rounded_radical.hpp).
// Cost: some 60 ns; with integers some microseconds.
#pragma once

#include "arith/exact_sum.hpp"

namespace plumb::arith::radial {

/// (K + W / sqrt(D)) / N, with D > 0 unless W is zero, and N > 0.
template <class T>
struct Parts {
  T k, w, d;
  T n{1.0};
};

double rounded_exactly(Rounding rounding, const Parts<BigDyadic>& parts);

/// Of parts that a lambda makes of a maker of numbers (exact_sum.hpp).
template <class Make>
double rounded(Rounding rounding, const Make& make) {
  const Parts<Ball> quick = make(arith::exact_sum::to_ball);
  const bool plain = quick.w.high == 0 && quick.w.radius == 0;  // low is 0 then
  const Ball sum = plain ? quick.k : quick.k + quotient(quick.w, root(quick.d));
  const Ball value = quick.n.high == 1 && quick.n.low == 0 ? sum : quotient(sum, quick.n);
  if (const auto x = value.rounded(rounding)) return *x;
  return rounded_exactly(rounding, make(arith::exact_sum::to_big));
}

}  // namespace plumb::arith::radial
