// Where in a triangle does a ray hit it?  The barycentric coordinates u and v of the hit.
//
//   hit_barycentric(ray, triangle)            nothing, or { u, v } of the point that first_hit names
//   exact_hit_barycentric(ray, triangle)      the same as rational numbers
//
// The point is a + u (b - a) + v (c - a), so that the weight of corner a is 1 - u - v.
// Laws: (1) there are coordinates exactly where first_hit (query/ray/ray.hpp) has a hit by closed sets, and they are those
// of its exact point, also where the ray runs in the plane of the triangle.  (2) u and v are the exact numbers rounded once
// to the nearest double, never -0; so each is in [0, 1], zero on edge ca and ab and nowhere else but below the least
// double.  (3) A triangle whose corners are on one line has no such coordinates of its own: they are those along the first
// of ab, bc, ca that holds the point; at a corner they are that corner's, the first one's of equal ones.
// NaN and infinity throw NonFinite, by name.
// Source: RTCD 3.4, 5.3.6.
// Cost: some 0.8 us; some 20 us where pairs of doubles leave a doubt, as at corners.  Nothing is searched.
#pragma once

#include <optional>

#include "plumb/arith/rational.hpp"
#include "plumb/query/ray/ray.hpp"

namespace plumb {

struct HitBarycentric {
  double u, v;
  friend bool operator==(const HitBarycentric&, const HitBarycentric&) = default;
};

struct ExactHitBarycentric {
  Rational u, v;
};

std::optional<HitBarycentric> hit_barycentric(const AnyRay& ray, const Triangle3& triangle);
std::optional<ExactHitBarycentric> exact_hit_barycentric(const AnyRay& ray, const Triangle3& triangle);

}  // namespace plumb
