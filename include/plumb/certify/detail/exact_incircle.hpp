// Does an exact point lie inside the circle of three others?
//
// Laws: for counterclockwise a, b, c positive when d is inside their circle, zero when cocircular or all collinear;
// that of incircle for any mix of points as given and constructed.
// Source: predicates/homogeneous.hpp; docs/implicit_points.md.
// Cost: that of exact_point.hpp.
#pragma once

#include "plumb/certify/exact_point.hpp"

namespace plumb {

Sign incircle(const ExactPoint2& a, const ExactPoint2& b, const ExactPoint2& c, const ExactPoint2& d);

}  // namespace plumb
