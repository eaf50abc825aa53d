// Which planes do these words mean?  What `plumb section --plane` takes.
//
//   z=1.5                                 the points of that height; x and y likewise
//   z=0:10:0.2                            heights from 0 by 0.2 up to 10, as decimals
//   NX,NY,NZ,OFFSET                       the points x with normal . x = offset
//   AX,AY,AZ,BX,BY,BZ,CX,CY,CZ            the plane of three points, that sees them counterclockwise
//
// Laws: a decimal stands for its nearest double, and it is told whether that is it; other words throw Error, which
// quotes them.
// Source: none.
// Cost: that of decimal_range.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "plumb/query/section/planes.hpp"

namespace plumb::tool {

struct NamedPlane {
  std::string name;  // "z=1.5"
  AnyPlane3 plane;
  bool exact;  // no decimal of it was moved
};

inline constexpr std::size_t most_planes = 1'000'000;

std::vector<NamedPlane> planes_of(std::string_view words);

}  // namespace plumb::tool
