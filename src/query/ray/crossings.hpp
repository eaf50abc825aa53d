// Which triangles does a ray along x cross, and which way?  One triangle after the other.
//
// orient2d(a, b, p) changes with the y of p as a.z - b.z, with its z as b.y - a.y.  p is moved in y by far more than in
// z, and in x by far more than in y, which is not seen; so the moved point is on no edge but of one whose ends are one
// point.  Where it is in a triangle and p is not on that, p is off the triangle's plane.
// Laws: those of plumb/query/ray/parity.hpp.
// Source: RTCD 5.4.3.
// Cost: four comparisons a triangle; an exact sign for those that the ray's line passes through.
#pragma once

#include <algorithm>
#include <cstdint>

#include "plumb/figure/containment/contains.hpp"
#include "plumb/predicates.hpp"

namespace plumb::query {

/// The side of the edge from a to b on which the moved p lies; zero only where a and b are seen as one point.
inline Sign moved_side(const Point3& a, const Point3& b, const Point3& p) {
  if (const Sign s = orient2d({a.y, a.z}, {b.y, b.z}, {p.y, p.z}); s != Sign::zero) return s;
  return a.z != b.z ? sign_of_number(a.z - b.z) : sign_of_number(b.y - a.y);
}

struct CoordinateRange {
  double least, most;
  CoordinateRange(double a, double b, double c)
      : least(std::min(std::min(a, b), c)), most(std::max(std::max(a, b), c)) {}
  [[nodiscard]] bool holds(double x) const { return least <= x && x <= most; }
};

struct Crossings {
  std::uint64_t count = 0;
  std::int64_t outward = 0;  // less those inward

  /// False where p is on the triangle.
  [[nodiscard]] bool take(const Triangle3& triangle, const Point3& p) {
    const auto& [a, b, c] = triangle;
    const CoordinateRange y(a.y, b.y, c.y), z(a.z, b.z, c.z);
    if (!y.holds(p.y) || !z.holds(p.z)) return true;
    const CoordinateRange x(a.x, b.x, c.x);
    if (x.most < p.x) return true;
    if (x.least <= p.x && contains(Triangle3{a, b, c}, p)) return false;
    const Sign way = moved_side(a, b, p);
    if (way == Sign::zero || moved_side(b, c, p) != way || moved_side(c, a, p) != way) return true;
    // The triangle turns counterclockwise, seen from where the ray goes, where it is left on the way out.
    if (x.least <= p.x && orient3d(a, b, c, p) != way) return true;
    ++count;
    outward += static_cast<int>(way);
    return true;
  }
};

}  // namespace plumb::query
