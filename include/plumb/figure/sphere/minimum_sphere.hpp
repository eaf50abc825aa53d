// Minimum enclosing ball: which is the smallest circle or sphere around all points, and which points hold it?
//
// Laws: (1) the support is one to four of the points (three in the plane) on whose boundary the exact smallest ball
// rests: its center is a convex combination of them with positive weights, and every point lies in it, exactly, however
// many lie on it.  (2) The order of the input changes nothing but indices: the support is named in the lexicographic
// order of its points, of equal points the first, and of several possible supports the same is chosen.  (3) The sphere
// in doubles has the exact center rounded once, and the least radius in doubles with which it encloses every point from
// there.  (4) The ball of a part is never larger than that of the whole.
// (5) Of balls likewise: the support is of balls that the smallest one touches from within, no fewer of which hold it.
// No points or balls, and a negative radius, throw InvalidShape; NaN and infinity throw NonFinite; a radius that no
// double holds throws BeyondDoubles.
// Source: RTCD 4.3.5; Welzl 1991; Gaertner 1999 for the pivot, the farthest point; Fischer and Gaertner 2003 for balls.
// Doubles propose it, exact signs decide everything.
// Cost: some passes over the points at 1 to 2 ns a point, and some 20 us; where many points lie on the boundary or off
// it by ulps, an exact sign for each of them.  Of balls some passes at 5 ns a ball in doubles, and 0.1 ms in rationals
// that prove what these found; some ms where they did not.  Bounded by n expected exact signs for each of the at most
// five points that span a sphere, whatever the points are, as they are taken in an order drawn at random; of integers
// as long as the exponents' span.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/figure/basic/round.hpp"
#include "plumb/figure/sphere/spanned_sphere.hpp"

namespace plumb {

struct MinimumCircle {
  Circle2 circle;
  SpannedCircle2 exact;                // through the points of the support
  std::vector<std::uint32_t> support;  // indices into the input
};
struct MinimumSphere {
  Sphere3 sphere;
  SpannedSphere3 exact;
  std::vector<std::uint32_t> support;
};

struct MinimumCircleOptions {
  std::vector<SpannedCircle2>* history = nullptr;  // gets every ball on the way, each larger than the one before
};
struct MinimumSphereOptions {
  std::vector<SpannedSphere3>* history = nullptr;
};

MinimumCircle minimum_circle(std::span<const Point2> points, const MinimumCircleOptions& options = {});
MinimumSphere minimum_sphere(std::span<const Point3> points, const MinimumSphereOptions& options = {});

struct MinimumCircleOfCircles {
  Circle2 circle;
  std::vector<std::uint32_t> support;
};
struct MinimumSphereOfSpheres {
  Sphere3 sphere;
  std::vector<std::uint32_t> support;
};

MinimumCircleOfCircles minimum_circle(std::span<const Circle2> circles);
MinimumSphereOfSpheres minimum_sphere(std::span<const Sphere3> spheres);

}  // namespace plumb
