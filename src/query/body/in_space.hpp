// Figures of the plane as figures of space: what is flat lies in z = 0, what halfplanes bound goes up and down forever.
//
// Law: exact.  An oriented box is a rectangle.
// Source: RTCD 3.2.
// Cost: a copy.
#pragma once

#include "figure/basic/in_space.hpp"
#include "plumb/figure/basic/plane.hpp"
#include "plumb/figure/basic/polygon.hpp"
#include "plumb/figure/k_dop/k_dop.hpp"

namespace plumb {

inline Halfspace3 in_space(const Halfspace2& h) { return {in_space(h.normal), h.offset}; }
inline Quadrilateral3 in_space(const Quadrilateral2& q) {
  return {in_space(q.a), in_space(q.b), in_space(q.c), in_space(q.d)};
}
inline Rectangle3 in_space(const Obb2& b) {
  return {in_space(b.center), {in_space(b.axes[0]), in_space(b.axes[1])}, b.half};
}

inline Polygon3 in_space(const Polygon2& polygon) {
  Polygon3 to;
  to.vertices.reserve(polygon.vertices.size());
  for (const Point2& p : polygon.vertices) to.vertices.push_back(in_space(p));
  return to;
}
inline HoledPolygon3 in_space(const HoledPolygon2& polygon) {
  HoledPolygon3 to{in_space(polygon.outer), {}};
  for (const Polygon2& hole : polygon.holes) to.holes.push_back(in_space(hole));
  return to;
}

inline HalfspaceIntersection3 in_space(const HalfspaceIntersection2& intersection) {
  HalfspaceIntersection3 to;
  for (const Halfspace2& h : intersection.halfspaces) to.halfspaces.push_back(in_space(h));
  return to;
}
inline KDop3 in_space(const KDop2& k_dop) {
  std::vector<Vector3> directions;
  for (const Vector2& d : k_dop.directions.all()) directions.push_back(in_space(d));
  return {Directions3(directions), k_dop.min, k_dop.max};
}

}  // namespace plumb
