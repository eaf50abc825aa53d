// Ray-triangle test, signed volumes: how does a directed line pass the three edges of a triangle?  The signs of the
// ray-triangle test.
//
// Laws: (1) for a triangle with an inside and a line that is not in its plane: they meet exactly when no two of the
// edge signs are opposite; all positive (negative) where the line goes through the inside and comes from where a, b, c
// turn counterclockwise (clockwise).  (2) The triangle on the other side of an edge is told the opposite sign of it, so
// no line slips through a closed mesh.  (3) All three zero: the line lies in the triangle's plane, or the direction is
// zero, or the triangle is a segment or a point in one plane with the line.  (4) Reversing the line flips all signs.
// A coordinate that is NaN or infinite throws NonFinite.
// Source: RTCD 5.3.4, 5.3.6.
// Cost: three signs of degree 3.
#pragma once

#include "plumb/arith/point.hpp"
#include "plumb/certify/decide.hpp"
#include "plumb/predicates/line_triangle.hpp"

namespace plumb {

/// On which side of each edge the line passes: positive on the left, as seen from where the line comes.
struct EdgeSigns {
  Sign ab, bc, ca;
  friend constexpr bool operator==(const EdgeSigns&, const EdgeSigns&) = default;

  /// No two are opposite.
  [[nodiscard]] constexpr bool agree() const {
    const auto is = [this](Sign s) { return ab == s || bc == s || ca == s; };
    return !(is(Sign::negative) && is(Sign::positive));
  }
  friend constexpr EdgeSigns operator-(const EdgeSigns& s) { return {-s.ab, -s.bc, -s.ca}; }
};

/// Positive when the line passes the edge from a to b on its left, as seen from where the line comes; zero when line
/// and edge lie in one plane.
template <int = 0>
inline Sign line_edge(const Point3& origin, const Vector3& direction, const Point3& a, const Point3& b) {
  return decide<predicates::LineEdge>({origin.x, origin.y, origin.z, direction.x, direction.y, direction.z,  //
                                       a.x, a.y, a.z, b.x, b.y, b.z});
}

/// The same for the line from p through q.
template <int = 0>
inline Sign line_edge(const Point3& p, const Point3& q, const Point3& a, const Point3& b) {
  return decide<predicates::Orient3d>({p.x, p.y, p.z, q.x, q.y, q.z, a.x, a.y, a.z, b.x, b.y, b.z});
}

template <int = 0>
inline EdgeSigns edge_signs(const Point3& origin, const Vector3& direction,  //
                            const Point3& a, const Point3& b, const Point3& c) {
  return {line_edge(origin, direction, a, b), line_edge(origin, direction, b, c), line_edge(origin, direction, c, a)};
}

/// Of the line from p through q.
template <int = 0>
inline EdgeSigns edge_signs(const Point3& p, const Point3& q, const Point3& a, const Point3& b, const Point3& c) {
  return {line_edge(p, q, a, b), line_edge(p, q, b, c), line_edge(p, q, c, a)};
}

}  // namespace plumb
