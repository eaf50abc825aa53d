// How far is it, exactly?  The root of a rational number, less a radius, and how two of these compare.
//
// Laws: the distance is sqrt(square) - inset, and zero where that is negative: the distance of a point from a ball is
// that from its center, less the radius.  compare is the sign of the first distance minus the second, in real
// arithmetic; a number compared with may be negative, and is then below every distance.
// Source: RTCD 5.1; signs of radicals by repeated squaring (certify/radical.hpp).
// Cost: some microseconds.
#pragma once

#include "plumb/arith/rational.hpp"
#include "plumb/arith/sign.hpp"

namespace plumb {

struct ExactDistance {
  Rational square;
  Rational inset{0.0};
};

Sign compare(const ExactDistance& a, const ExactDistance& b);
Sign compare(const ExactDistance& a, double b);

}  // namespace plumb
