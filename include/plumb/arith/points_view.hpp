// Where are many points, when each coordinate has an array of its own?  Views of structures of arrays.
//
// Laws: a view owns nothing; its spans are of equal length, which what takes a view looks at (UnequalLengths).
// Source: RTCD 13.7.
// Cost: none.
#pragma once

#include <span>

#include "plumb/predicates/standard.hpp"

namespace plumb {

struct Points2View {
  std::span<const double> x, y;
};

struct Points3View {
  std::span<const double> x, y, z;
};

}  // namespace plumb
