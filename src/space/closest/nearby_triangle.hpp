// How far apart are posed triangles, or one and a point, at least?  By triangles of doubles, and how far these are off.
//
// Law: distance_below is at most the distance of the exact images.
// Source: RTCD 5.1.5, 5.1.10.
// Cost: that of triangles as they are given.
#pragma once

#include <algorithm>
#include <limits>

#include "plumb/query/closest/closest.hpp"
#include "plumb/query/closest/pairs.hpp"
#include "space/bvh/posed_box.hpp"

namespace plumb::space {

inline constexpr double beyond_all = std::numeric_limits<double>::infinity();

/// No less than the distance of any two points of the box.
inline double far_within(const Aabb3& box) {
  const double x = raised(box.max.x - box.min.x), y = raised(box.max.y - box.min.y);
  return raised(raised(x + y) + raised(box.max.z - box.min.z));
}

/// A triangle of doubles, and how far from it a point of the posed one can be: no farther than a corner.
struct NearbyTriangle {
  Triangle3 triangle;
  double off;

  explicit NearbyTriangle(const PosedTriangle& t) : triangle(t.shape), off(0) {
    for (Point3* p : {&triangle.a, &triangle.b, &triangle.c}) {
      const Aabb3 box = around(t.pose, *p);
      if (!is_bounded(box)) off = beyond_all;
      *p = box.min;
      off = std::max(off, far_within(box));
    }
  }
};

/// At most the distance of the posed triangles, and of a point.
inline double distance_below(const NearbyTriangle& s, const NearbyTriangle& t) {
  const double off = raised(s.off + t.off);
  return off < beyond_all ? lowered(lowered(distance(s.triangle, t.triangle)) - off) : 0;
}
inline double distance_below(const NearbyTriangle& s, const Point3& p) {
  return s.off < beyond_all ? lowered(lowered(distance(p, s.triangle)) - s.off) : 0;
}

}  // namespace plumb::space
