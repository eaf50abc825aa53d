// Ray cast: which of two planes does a ray meet first, and does it meet one before a given parameter?
//
// The parameter t counts multiples of the direction from the origin: t = 0 is the origin, and for a segment from p to q
// t = 1 is q.  The ray is taken as a whole line here: parameters may be negative.  Planes are given by three points
// each.
// Laws: (1) comparing in the other order flips the sign.  (2) The points of a plane may be permuted.  (3) Nothing is
// answered exactly when a plane has no single parameter: it is parallel to the line (or contains it), its three points
// are collinear, or the direction is zero.  (4) A segment's parameters are those of the ray with the unrounded
// direction q - p.
// A coordinate that is NaN or infinite throws NonFinite.
// Source: RTCD 5.3.1, 5.3.6.
// Cost: two or three signs of degree 3, 4 or 6.
#pragma once

#include <array>
#include <optional>

#include "plumb/arith/point.hpp"
#include "plumb/arith/sign.hpp"

namespace plumb {

/// Sign of t1 - t2, where t1 and t2 are the parameters of the first and the second plane: negative when the first is
/// met first.
std::optional<Sign> compare_ray_parameters(const Point3& origin, const Vector3& direction,
                                           const std::array<Point3, 3>& first, const std::array<Point3, 3>& second);
std::optional<Sign> compare_segment_parameters(const Point3& p, const Point3& q,  //
                                               const std::array<Point3, 3>& first, const std::array<Point3, 3>& second);

/// Sign of the plane's parameter minus t.
std::optional<Sign> compare_ray_parameter(const Point3& origin, const Vector3& direction,
                                          const std::array<Point3, 3>& plane, double t);
std::optional<Sign> compare_segment_parameter(const Point3& p, const Point3& q,  //
                                              const std::array<Point3, 3>& plane, double t);

}  // namespace plumb
