// Bounding volume (sphere): which sphere around the points, quickly?  Four fits in the order of their cost, all
// enclosing for certain.
//
// Laws: (1) every point is contained, exactly: doubles choose the center, the radius is the distance of the farthest
// point from it, rounded up once.  (2) The same points in the same order give the same sphere, everywhere.  (3) All
// equal points give radius 0.
// No points throw InvalidShape; NaN and infinity throw NonFinite; a radius that no double holds throws BeyondDoubles.
// Source: RTCD 4.3.2 (box midpoint; Ritter 1990), 4.3.3 (Wu 1992), 4.3.4.
// Cost: two passes over the points for the box, four for Ritter, six for the principal axis, two and one for each
// iteration; a pass costs 1 to 3 ns a point.  How tight they are: docs/bounds.md.  The smallest of all, minimum_sphere,
// often costs no more.  Bounded by n operations a pass.
#pragma once

#include <span>
#include <vector>

#include "plumb/figure/basic/round.hpp"

namespace plumb {

/// Around the midpoint of the axis-aligned box.
Sphere3 fit_sphere_box(std::span<const Point3> points);

/// From the most distant of the pairs of points that are extreme along an axis, grown to take in each point in turn.
Sphere3 fit_sphere_ritter(std::span<const Point3> points);

/// Likewise, from the two points extreme along the direction of the largest spread.
Sphere3 fit_sphere_principal(std::span<const Point3> points);

struct IteratedRitterOptions {
  int iterations = 8;
  double shrink = 0.95;                     // of the radius, before the points are taken in again
  std::vector<Sphere3>* history = nullptr;  // gets the sphere after each iteration, the first one first; not rounded up
};

/// Ritter's sphere, shrunk and grown again over the points in ever other orders; the best of all.
Sphere3 fit_sphere_iterated_ritter(std::span<const Point3> points, const IteratedRitterOptions& options = {});

}  // namespace plumb
