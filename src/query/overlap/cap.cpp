// Spherical caps against balls and against flat convex sets: a cap is a ball and a halfspace, and meets what meets the
// ball within the halfspace.
#include "plumb/figure/containment/contains.hpp"
#include "query/body/figure_input.hpp"
#include "query/convex/cap_relation.hpp"
#include "query/overlap/pair_answer.hpp"

namespace plumb {
namespace query {
namespace {

template <class Flat>
Relation relate_cap(const Flat& x, const SphericalCap3& cap, Question question) {
  require_figures(question, x, cap);
  if constexpr (std::is_same_v<Flat, Point3>) {
    const Location where = locate(cap, x);
    if (where != Location::boundary) return static_cast<Relation>(where);
  }
  if (!intersects(x, cap.sphere) || !intersects(x, cap.halfspace)) return Relation::disjoint;
  return relate_exact_cap(flat_set(x), cap);
}

Relation relate_ball_and_cap(const Sphere3& ball, const SphericalCap3& cap, Question question) {
  require_figures(question, ball, cap);
  if (ball.radius == 0) return relate_cap(ball.center, cap, question);
  if (!intersects(ball, cap.sphere) || !intersects(ball, cap.halfspace)) return Relation::disjoint;
  return relate_exact_cap(Exact3{ball.center.x, ball.center.y, ball.center.z}, mpq_class(ball.radius) * ball.radius,
                          cap);
}

}  // namespace

PLUMB_PAIR_ANSWERS_TO(SphericalCap3, relate_cap, Point3, Line3, Ray3, Segment3, Plane3, ThreePointPlane3, Halfspace3,
                      Triangle3, Rectangle3, Tetrahedron3, Aabb3, Obb3, KDop3, HalfspaceIntersection3,
                      ConvexPolyhedron3)
PLUMB_PAIR_ANSWER(Sphere3, SphericalCap3, relate_ball_and_cap)

}  // namespace query
}  // namespace plumb
