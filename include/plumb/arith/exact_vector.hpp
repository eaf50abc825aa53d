// Which direction, exactly?  A vector of rational coordinates.
//
// Laws: exact; equal are those of equal coordinates, not of equal directions.
// Source: RTCD 3.3.
// Cost: an allocation a coordinate.
#pragma once

#include "plumb/arith/rational.hpp"

namespace plumb {

struct ExactVector3 {
  Rational x, y, z;
  friend bool operator==(const ExactVector3&, const ExactVector3&) = default;
};

}  // namespace plumb
