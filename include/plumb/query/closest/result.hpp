// Closest points and closest features: how close do two figures come, where, and between which of their features?  What
// the questions of closest.hpp answer.
//
// Laws: features are exact (figure/containment/voronoi_region.hpp numbers them; a line and a ray are edge 0, a ray's origin is
// vertex 0, a plane and the surface of a ball are face 0); coordinates and the distance are the exact values, each
// rounded once to the nearest double, infinite where they are beyond all doubles.  A solid contains its inside: there
// the distance is zero, both points are the same, and its feature is the interior.
// Source: RTCD 5.1.
// Cost: none.
#pragma once

#include "plumb/arith/point.hpp"
#include "plumb/figure/containment/voronoi_region.hpp"

namespace plumb {

struct Closest {
  Point3 on_a, on_b;
  double distance;
  Feature feature_a, feature_b;
  friend bool operator==(const Closest&, const Closest&) = default;
};

/// In the plane, where the inside of a shape is its face.
struct Closest2 {
  Point2 on_a, on_b;
  double distance;
  Feature feature_a, feature_b;
  friend bool operator==(const Closest2&, const Closest2&) = default;
};

/// The same answer with the figures named the other way round.
constexpr Closest swapped(const Closest& c) { return {c.on_b, c.on_a, c.distance, c.feature_b, c.feature_a}; }
constexpr Closest2 swapped(const Closest2& c) { return {c.on_b, c.on_a, c.distance, c.feature_b, c.feature_a}; }

}  // namespace plumb
