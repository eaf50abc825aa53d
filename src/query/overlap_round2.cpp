// Figures of the plane as figures of space: what is flat lies in z = 0, what halfplanes bound goes up and down forever.
#include "plumb/query/overlap_round2.hpp"

#include "figure_input.hpp"
#include "plumb/query/overlap_round.hpp"

namespace plumb {
namespace query {
namespace {

Point3 lifted(const Point2& p) { return {p.x, p.y, 0}; }
Vector3 lifted(const Vector2& v) { return {v.x, v.y, 0}; }
Line3 lifted(const Line2& l) { return {lifted(l.point), lifted(l.direction)}; }
Ray3 lifted(const Ray2& r) { return {lifted(r.origin), lifted(r.direction)}; }
Segment3 lifted(const Segment2& s) { return {lifted(s.a), lifted(s.b)}; }
Halfspace3 lifted(const Halfspace2& h) { return {lifted(h.normal), h.offset}; }
Triangle3 lifted(const Triangle2& t) { return {lifted(t.a), lifted(t.b), lifted(t.c)}; }
Quadrilateral3 lifted(const Quadrilateral2& q) { return {lifted(q.a), lifted(q.b), lifted(q.c), lifted(q.d)}; }
Aabb3 lifted(const Aabb2& b) { return {lifted(b.min), lifted(b.max)}; }
Rectangle3 lifted(const Obb2& b) { return {lifted(b.center), {lifted(b.axes[0]), lifted(b.axes[1])}, b.half}; }
Sphere3 lifted(const Circle2& c) { return {lifted(c.center), c.radius}; }
Capsule3 lifted(const Capsule2& c) { return {lifted(c.a), lifted(c.b), c.radius}; }

Polygon3 lifted(const Polygon2& polygon) {
  Polygon3 to;
  to.vertices.reserve(polygon.vertices.size());
  for (const Point2& p : polygon.vertices) to.vertices.push_back(lifted(p));
  return to;
}
HoledPolygon3 lifted(const HoledPolygon2& polygon) {
  HoledPolygon3 to{lifted(polygon.outer), {}};
  for (const Polygon2& hole : polygon.holes) to.holes.push_back(lifted(hole));
  return to;
}
HalfspaceIntersection3 lifted(const HalfspaceIntersection2& intersection) {
  HalfspaceIntersection3 to;
  for (const Halfspace2& h : intersection.halfspaces) to.halfspaces.push_back(lifted(h));
  return to;
}
HalfspaceIntersection3 lifted(const KDop2& k_dop) {
  HalfspaceIntersection3 to;
  for (std::size_t i = 0; i < k_dop.directions.size(); ++i) {
    const auto [x, y] = k_dop.directions.all()[i];
    to.halfspaces.push_back({{x, y, 0}, k_dop.max[i]});
    to.halfspaces.push_back({{-x, -y, 0}, -k_dop.min[i]});
  }
  return to;
}

template <class A, class B>
Relation relate_lifted(const A& a, const B& b, Asked asked) {
  require_figures(asked, a, b);
  return relate(lifted(a), lifted(b));
}

}  // namespace
}  // namespace query

using query::relate_lifted;

Relation relate(const Point2& a, const Circle2& b, Asked asked) { return relate_lifted(a, b, asked); }
Relation relate(const Line2& a, const Circle2& b, Asked asked) { return relate_lifted(a, b, asked); }
Relation relate(const Ray2& a, const Circle2& b, Asked asked) { return relate_lifted(a, b, asked); }
Relation relate(const Segment2& a, const Circle2& b, Asked asked) { return relate_lifted(a, b, asked); }
Relation relate(const Halfspace2& a, const Circle2& b, Asked asked) { return relate_lifted(a, b, asked); }
Relation relate(const Triangle2& a, const Circle2& b, Asked asked) { return relate_lifted(a, b, asked); }
Relation relate(const Quadrilateral2& a, const Circle2& b, Asked asked) { return relate_lifted(a, b, asked); }
Relation relate(const Polygon2& a, const Circle2& b, Asked asked) { return relate_lifted(a, b, asked); }
Relation relate(const HoledPolygon2& a, const Circle2& b, Asked asked) { return relate_lifted(a, b, asked); }
Relation relate(const Circle2& a, const Aabb2& b, Asked asked) { return relate_lifted(a, b, asked); }
Relation relate(const Circle2& a, const Obb2& b, Asked asked) { return relate_lifted(b, a, asked); }
Relation relate(const Circle2& a, const Capsule2& b, Asked asked) { return relate_lifted(a, b, asked); }
Relation relate(const Circle2& a, const KDop2& b, Asked asked) { return relate_lifted(a, b, asked); }
Relation relate(const Circle2& a, const HalfspaceIntersection2& b, Asked asked) { return relate_lifted(a, b, asked); }

Relation relate(const Point2& a, const Capsule2& b, Asked asked) { return relate_lifted(a, b, asked); }
Relation relate(const Line2& a, const Capsule2& b, Asked asked) { return relate_lifted(a, b, asked); }
Relation relate(const Ray2& a, const Capsule2& b, Asked asked) { return relate_lifted(a, b, asked); }
Relation relate(const Segment2& a, const Capsule2& b, Asked asked) { return relate_lifted(a, b, asked); }
Relation relate(const Halfspace2& a, const Capsule2& b, Asked asked) { return relate_lifted(a, b, asked); }
Relation relate(const Triangle2& a, const Capsule2& b, Asked asked) { return relate_lifted(a, b, asked); }
Relation relate(const Quadrilateral2& a, const Capsule2& b, Asked asked) { return relate_lifted(a, b, asked); }
Relation relate(const Polygon2& a, const Capsule2& b, Asked asked) { return relate_lifted(a, b, asked); }
Relation relate(const HoledPolygon2& a, const Capsule2& b, Asked asked) { return relate_lifted(a, b, asked); }
Relation relate(const Aabb2& a, const Capsule2& b, Asked asked) { return relate_lifted(a, b, asked); }
Relation relate(const Obb2& a, const Capsule2& b, Asked asked) { return relate_lifted(a, b, asked); }
Relation relate(const Capsule2& a, const KDop2& b, Asked asked) { return relate_lifted(a, b, asked); }
Relation relate(const Capsule2& a, const HalfspaceIntersection2& b, Asked asked) { return relate_lifted(a, b, asked); }

}  // namespace plumb
