// Which numbers say a hull, in whatever order its points were given?  For constructions whose roundings depend on it.
//
// Laws: (1) points that differ in their order, in repetitions, in what lies within the hull or in signs of zeros alone
// give the same bits.  (2) `hull` is what convex_hull gives for `vertices`, which are ordered by x, then y, then z, and
// have no -0.
// Source: none.
// Cost: a sort of the vertices, one of the faces.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "plumb/figure/hull/hull3.hpp"

namespace plumb::figure {

struct CanonicalHull {
  std::vector<Point3> vertices;
  Hull3 hull;

  /// `given` is convex_hull(points).  Throws InvalidShape, by the name of the function that asks, where it names a
  /// point that there is not.
  CanonicalHull(std::string_view function, const Hull3& given, std::span<const Point3> points);
};

}  // namespace plumb::figure
