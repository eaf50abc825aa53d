// Circles and capsules of the plane as balls and capsules of space.
#include "query/body/figure_input.hpp"
#include "query/body/in_space.hpp"
#include "query/overlap/pair_answer.hpp"

namespace plumb {
namespace query {
namespace {

template <class A, class B>
Relation relate_lifted(const A& a, const B& b, Question question) {
  require_figures(question, a, b);
  return relate(in_space(a), in_space(b));
}

}  // namespace
PLUMB_PAIR_ANSWERS_TO(Circle2, relate_lifted, Point2, Line2, Ray2, Segment2, Halfspace2, Triangle2, Quadrilateral2,
                      Polygon2, HoledPolygon2)
PLUMB_PAIR_ANSWERS_OF(Circle2, relate_lifted, Aabb2, Obb2, KDop2, HalfspaceIntersection2)
PLUMB_PAIR_ANSWERS_TO(Capsule2, relate_lifted, Circle2, Point2, Line2, Ray2, Segment2, Halfspace2, Triangle2,
                      Quadrilateral2, Polygon2, HoledPolygon2, Aabb2, Obb2)
PLUMB_PAIR_ANSWERS_OF(Capsule2, relate_lifted, KDop2, HalfspaceIntersection2)

}  // namespace query
}  // namespace plumb
