// Triangles, polygons and planes as what bounds them, and what is flat though it need not be.
#include <string>

#include "plumb/arith/error.hpp"
#include "plumb/figure/basic/convexity.hpp"
#include "plumb/figure/hull/hull2.hpp"
#include "query/convex/set_parts.hpp"

namespace plumb::query::meeting {
namespace {

Bound<3> on_plane(const Point3& a, const Point3& b, const Point3& c) {
  Bound<3> bound{Bound<3>::Kind::face, 0};
  bound.a = a, bound.b = b, bound.c = c;
  return bound;
}

template <std::size_t N>
void add_sides(ConvexSet<N>& set, std::size_t axis, int side) {
  set.first_side = static_cast<int>(set.bounds.size());
  const std::size_t n = set.vertices.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = i + 1 < n ? i + 1 : 0;
    Bound<N> bound{Bound<N>::Kind::line, side};
    bound.axis = axis;
    bound.a = set.vertices[i], bound.b = set.vertices[next];
    set.bounds.push_back(bound);
    set.edges.push_back({.from = static_cast<int>(i), .to = static_cast<int>(next)});
  }
}

template <class P>
const P& least(const P& a, const P& b) {
  return compare_lexicographically(a, b) == Sign::positive ? b : a;
}
template <class P>
const P& most(const P& a, const P& b) {
  return compare_lexicographically(a, b) == Sign::positive ? a : b;
}

ConvexSet<2> polygon_set(std::vector<Point2> vertices, int turn) {
  ConvexSet<2> set;
  set.dimension = 2;
  set.vertices = std::move(vertices);
  set.bounds.reserve(set.vertices.size());
  set.edges.reserve(set.vertices.size());
  add_sides(set, 0, -turn);
  return set;
}

std::size_t axis_of(Look look) { return look == Look::along_x ? 0 : look == Look::along_y ? 1 : 2; }

ConvexSet<3> plane_set(const Vector3& normal, double offset, int side) {
  ConvexSet<3> set;
  if (normal == Vector3{}) {  // all of space, or nothing
    set.dimension = offset == 0 || (side != 0 && offset > 0) ? 3 : -1;
    return set;
  }
  set.dimension = side == 0 ? 2 : 3;
  if (side == 0) set.look = normal.z != 0 ? 2 : normal.x != 0 ? 0 : 1;
  Bound<3> bound{Bound<3>::Kind::normal, side};
  bound.direction = normal;
  bound.offset = offset;
  set.bounds = {bound};
  return set;
}

}  // namespace

ConvexSet<3> polygon_set(std::vector<Point3> vertices, const std::array<Point3, 3>& plane, std::size_t axis, int turn) {
  ConvexSet<3> set;
  set.dimension = 2;
  set.look = static_cast<int>(axis);
  set.vertices = std::move(vertices);
  set.bounds.reserve(set.vertices.size() + 1);
  set.edges.reserve(set.vertices.size());
  set.bounds.push_back(on_plane(plane[0], plane[1], plane[2]));
  add_sides(set, axis, -turn);
  return set;
}

ConvexSet<3> flat_set(std::span<const Point3> points) {
  const PlaneOfPoints plane = plane_of_points(points);
  if (plane.dimension == 0) return point_set<3>(points[0]);
  if (plane.dimension == 1) {
    Point3 from = points[0], to = points[0];
    for (const Point3& p : points) from = least(from, p), to = most(to, p);
    return segment_set<3>(from, to);
  }
  const std::array<Point3, 3> span{points[plane.span[0]], points[plane.span[1]], points[plane.span[2]]};
  const Look look = look_at_plane(span[0], span[1], span[2]);
  std::vector<Point2> flat;
  for (const Point3& p : points) flat.push_back(projected(look, p));
  std::vector<Point3> corners;
  for (const std::uint32_t i : convex_hull(flat).vertices) corners.push_back(points[i]);
  return polygon_set(std::move(corners), span, axis_of(look), 1);
}

ConvexSet<2> convex_set(const Triangle2& t) {
  const Sign turn = orient2d(t.a, t.b, t.c);
  if (turn != Sign::zero) return polygon_set({t.a, t.b, t.c}, static_cast<int>(turn));
  return segment_set<2>(least(t.a, least(t.b, t.c)), most(t.a, most(t.b, t.c)));
}

ConvexSet<2> convex_set(const Polygon2& polygon) {
  const PolygonConvexity c = convexity(polygon);
  if (c.is_convex()) return polygon_set(polygon.vertices, static_cast<int>(c.orientation));
  if (c.kind != PolygonKind::degenerate)
    throw InvalidShape("intersection: polygon is not convex; triangulate it or intersect its convex pieces");
  Point2 from = polygon.vertices[0], to = from;
  for (const Point2& p : polygon.vertices) from = least(from, p), to = most(to, p);
  return segment_set<2>(from, to);
}

ConvexSet<3> convex_set(const Polygon3& polygon) {
  const PolygonKind kind = convexity(polygon).kind;
  if (kind == PolygonKind::not_planar)
    throw InvalidShape("intersection: polygon is not planar; triangulate it or intersect its triangles");
  if (kind == PolygonKind::concave || kind == PolygonKind::self_winding)
    throw InvalidShape("intersection: polygon is not convex; triangulate it or intersect its convex pieces");
  return flat_set(polygon.vertices);
}

ConvexSet<3> convex_set(const Triangle3& t) {
  for (const std::size_t axis : {2u, 0u, 1u}) {
    const Seen look = looks[axis];
    const Sign turn = orient2d(seen<3>(t.a, look), seen<3>(t.b, look), seen<3>(t.c, look));
    if (turn != Sign::zero) return polygon_set({t.a, t.b, t.c}, {t.a, t.b, t.c}, axis, static_cast<int>(turn));
  }
  return segment_set<3>(least(t.a, least(t.b, t.c)), most(t.a, most(t.b, t.c)));
}

ConvexSet<3> convex_set(const Plane3& plane) { return plane_set(plane.normal, plane.offset, 0); }
ConvexSet<3> convex_set(const Halfspace3& halfspace) { return plane_set(halfspace.normal, halfspace.offset, 1); }

ConvexSet<3> convex_set(const ThreePointPlane3& plane) {
  const auto& [a, b, c] = plane;
  if (collinear(a, b, c)) return line_set<3>(least(a, least(b, c)), most(a, most(b, c)));
  ConvexSet<3> set;
  set.dimension = 2;
  set.look = static_cast<int>(axis_of(look_at_plane(a, b, c)));
  set.bounds = {on_plane(a, b, c)};
  return set;
}

}  // namespace plumb::query::meeting
