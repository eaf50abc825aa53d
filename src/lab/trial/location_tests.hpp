// How is a point commonly located in a polygon and in a polyhedron?  A ray is cast, and its crossings are counted.
//
// Laws: none; they are on trial, and decide nothing of ours.  The boundary is nobody's: what such code says there
// depends on the side.  An epsilon moves the crossing of an edge; in space determinants within it count as zero.
// Source: RTCD 5.4.1, 5.3.4; Franklin, "PNPOLY".
// Cost: some operations an edge, tens a face.
#pragma once

#include "lab/trial/vec.hpp"

namespace plumb::lab::trial {

inline constexpr std::size_t polygon_corners = 8;
/// A point, and the corners of a polygon in turn.
using PolygonNumbers = std::array<double, 2 + 2 * polygon_corners>;

struct PointInPolygon {
  template <class T>
  bool operator()(const std::array<T, 2 + 2 * polygon_corners>& q, T epsilon) const {
    bool inside = false;
    for (std::size_t i = 0, j = polygon_corners - 1; i < polygon_corners; j = i++) {
      const T xi = q[2 + 2 * i], yi = q[3 + 2 * i], xj = q[2 + 2 * j], yj = q[3 + 2 * j];
      if ((yi > q[1]) != (yj > q[1]) && q[0] < (xj - xi) * (q[1] - yi) / (yj - yi) + xi + epsilon) inside = !inside;
    }
    return inside;
  }
};

/// The faces of the solid whose corners lie on the two sides of each axis, corner 2k + 1 opposite to 2k; outward.
inline constexpr std::array<std::array<std::size_t, 3>, 8> octahedron_faces{
    {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};

/// A point, and the six corners of such a solid: a ray along the first axis.
struct PointInPolyhedron {
  template <class T>
  bool operator()(const std::array<T, 21>& q, T epsilon) const {
    const Vec<T> o = vec(q, 0), d{T(1), T(0), T(0)};
    bool inside = false;
    for (const auto& face : octahedron_faces) {
      const Vec<T> a = vec(q, 1 + face[0]), e = vec(q, 1 + face[1]) - a, f = vec(q, 1 + face[2]) - a, p = cross(d, f);
      const T det = dot(e, p);
      if (magnitude(det) <= epsilon) continue;
      const Vec<T> s = o - a;
      const T u = dot(s, p) / det;
      if (u < 0 || u > 1) continue;
      const Vec<T> r = cross(s, e);
      const T v = dot(d, r) / det;
      if (v < 0 || u + v > 1) continue;
      if (dot(f, r) / det >= 0) inside = !inside;
    }
    return inside;
  }
};

}  // namespace plumb::lab::trial
