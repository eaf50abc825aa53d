// Which axes hold a needle tightly, whose thickness is below the roundings of a unit vector along it?
//
// Laws: the first axis is the difference of two of the points that are far apart, as a double that is often exact; any
// length of an axis will do for a box.  The others are at right angles to it up to rounding.  Thickness is measured
// along products of the first axis with others, which lose nothing of it.
// Source: none; RTCD 4.4.3 for the rectangle around what is seen along an axis.
// Cost: linear, some 0.5 us a point.
#pragma once

#include <array>
#include <span>

#include "plumb/arith/point.hpp"

namespace plumb::figure::frame {

/// Those of space where no two points are told apart.
std::array<Vector3, 3> needle_axes(std::span<const Point3> points);

}  // namespace plumb::figure::frame
