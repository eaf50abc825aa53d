// Figures of the plane as figures of space: what is flat lies in z = 0, what halfplanes bound goes up and down forever.
#include "figure/basic/in_space.hpp"
#include "query/body/figure_input.hpp"
#include "query/overlap/pair_answer.hpp"

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
Relation relate_lifted(const A& a, const B& b, Question question) {
  require_figures(question, a, b);
  return relate(in_space(a), in_space(b));
}

}  // namespace
PLUMB_PAIR_ANSWER(Point2, Circle2, relate_lifted)
PLUMB_PAIR_ANSWER(Line2, Circle2, relate_lifted)
PLUMB_PAIR_ANSWER(Ray2, Circle2, relate_lifted)
PLUMB_PAIR_ANSWER(Segment2, Circle2, relate_lifted)
PLUMB_PAIR_ANSWER(Halfspace2, Circle2, relate_lifted)
PLUMB_PAIR_ANSWER(Triangle2, Circle2, relate_lifted)
PLUMB_PAIR_ANSWER(Quadrilateral2, Circle2, relate_lifted)
PLUMB_PAIR_ANSWER(Polygon2, Circle2, relate_lifted)
PLUMB_PAIR_ANSWER(HoledPolygon2, Circle2, relate_lifted)
PLUMB_PAIR_ANSWER(Circle2, Aabb2, relate_lifted)
PLUMB_PAIR_ANSWER(Circle2, Obb2, relate_lifted)
PLUMB_PAIR_ANSWER(Circle2, Capsule2, relate_lifted)
PLUMB_PAIR_ANSWER(Circle2, KDop2, relate_lifted)
PLUMB_PAIR_ANSWER(Circle2, HalfspaceIntersection2, relate_lifted)

PLUMB_PAIR_ANSWER(Point2, Capsule2, relate_lifted)
PLUMB_PAIR_ANSWER(Line2, Capsule2, relate_lifted)
PLUMB_PAIR_ANSWER(Ray2, Capsule2, relate_lifted)
PLUMB_PAIR_ANSWER(Segment2, Capsule2, relate_lifted)
PLUMB_PAIR_ANSWER(Halfspace2, Capsule2, relate_lifted)
PLUMB_PAIR_ANSWER(Triangle2, Capsule2, relate_lifted)
PLUMB_PAIR_ANSWER(Quadrilateral2, Capsule2, relate_lifted)
PLUMB_PAIR_ANSWER(Polygon2, Capsule2, relate_lifted)
PLUMB_PAIR_ANSWER(HoledPolygon2, Capsule2, relate_lifted)
PLUMB_PAIR_ANSWER(Aabb2, Capsule2, relate_lifted)
PLUMB_PAIR_ANSWER(Obb2, Capsule2, relate_lifted)
PLUMB_PAIR_ANSWER(Capsule2, KDop2, relate_lifted)
PLUMB_PAIR_ANSWER(Capsule2, HalfspaceIntersection2, relate_lifted)

}  // namespace query
}  // namespace plumb
