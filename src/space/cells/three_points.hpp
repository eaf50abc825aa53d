// Three points of a plane by which signs are asked: of a face, of a polygon.
#pragma once

#include <array>
#include <span>

#include "plumb/certify/coplanar.hpp"
#include "plumb/predicates.hpp"

namespace plumb::space {

using ThreePoints = std::array<Point3, 3>;

inline bool on_one_line(const Point3& a, const Point3& b, const Point3& c) {
  return coplanar_orientation(a, b, c) == Sign::zero;
}

template <class Point>
Sign side(const ThreePoints& plane, const Point& p) {
  return orient3d(plane[0], plane[1], plane[2], p);
}

/// Of a convex chain of points: two of an edge, and one that is not on its line; that of its orientation.
template <class Corner>
ThreePoints plane_of_chain(std::size_t count, const Corner& corner) {
  for (std::size_t i = 0; i + 1 < count; ++i) {
    for (std::size_t j = i + 2; j < count; ++j) {
      if (!on_one_line(corner(i), corner(i + 1), corner(j))) return {corner(i), corner(i + 1), corner(j)};
    }
  }
  return {corner(0), corner(0), corner(0)};
}

inline ThreePoints turned_round(const ThreePoints& p) { return {p[0], p[2], p[1]}; }

}  // namespace plumb::space
