// Figures of the plane as figures of space: what is flat lies in z = 0, what halfplanes bound goes up and down forever.
#include "plumb/query/overlap/round2.hpp"

#include "figure/basic/in_space.hpp"
#include "plumb/query/overlap/round.hpp"
#include "query/body/figure_input.hpp"

namespace plumb {
namespace query {
namespace {

Halfspace3 in_space(const Halfspace2& h) { return {in_space(h.normal), h.offset}; }
Quadrilateral3 in_space(const Quadrilateral2& q) {
  return {in_space(q.a), in_space(q.b), in_space(q.c), in_space(q.d)};
}
Rectangle3 in_space(const Obb2& b) { return {in_space(b.center), {in_space(b.axes[0]), in_space(b.axes[1])}, b.half}; }

Polygon3 in_space(const Polygon2& polygon) {
  Polygon3 to;
  to.vertices.reserve(polygon.vertices.size());
  for (const Point2& p : polygon.vertices) to.vertices.push_back(in_space(p));
  return to;
}
HoledPolygon3 in_space(const HoledPolygon2& polygon) {
  HoledPolygon3 to{in_space(polygon.outer), {}};
  for (const Polygon2& hole : polygon.holes) to.holes.push_back(in_space(hole));
  return to;
}
HalfspaceIntersection3 in_space(const HalfspaceIntersection2& intersection) {
  HalfspaceIntersection3 to;
  for (const Halfspace2& h : intersection.halfspaces) to.halfspaces.push_back(in_space(h));
  return to;
}
HalfspaceIntersection3 in_space(const KDop2& k_dop) {
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
  return relate(in_space(a), in_space(b));
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
