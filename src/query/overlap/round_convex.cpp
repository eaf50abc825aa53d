// Balls, capsules and lozenges against convex shapes that are given by vertices.
#include "figure/support/near_points.hpp"
#include "query/body/figure_input.hpp"
#include "query/convex/core.hpp"
#include "query/convex/exact_gap.hpp"
#include "query/convex/search.hpp"
#include "query/overlap/box_quick.hpp"
#include "query/overlap/pair_answer.hpp"

namespace plumb {
namespace query {
namespace {

using figure::near_points::quick_gap;

std::optional<Sign> near_or_far(const Triangle3& t, const Sphere3& b) { return quick_gap(t, b.center, b.radius); }
std::optional<Sign> near_or_far(const Sphere3& b, const Obb3& box) {
  const auto told = quick_relation(b, box);
  return told ? std::optional(-static_cast<Sign>(*told)) : std::nullopt;
}
std::optional<Sign> near_or_far(const Segment3& s, const Capsule3& c) {
  return quick_gap(s, Segment3{c.a, c.b}, 0, c.radius);
}
std::optional<Sign> near_or_far(const Aabb3& box, const Capsule3& c) {
  if (!is_sound(box) || !is_sound(c) || is_empty(box)) return {};
  return quick_gap(box, Segment3{c.a, c.b}, c.radius);
}

template <class A, class B>
[[gnu::noinline]] Relation relate_by_cores(const A& a, const B& b, Question question) {
  const FigureView p = view_of(a), q = view_of(b);
  if (const auto found = relate_by_search({p}, {q})) [[likely]]
    return *found;
  require_figures(question, a, b);
  return relate_swept(core_of(p), radius_of(p), core_of(q), radius_of(q));
}

template <class A, class B>
Relation relate_round(const A& a, const B& b, Question question) {
  if constexpr (requires { near_or_far(a, b); }) {
    if (const auto gap = near_or_far(a, b)) [[likely]]
      return static_cast<Relation>(-*gap);
  }
  return relate_by_cores(a, b, question);
}

}  // namespace
PLUMB_PAIR_ANSWERS_TO(Sphere3, relate_round, Triangle3, Rectangle3, Tetrahedron3)
PLUMB_PAIR_ANSWER(Sphere3, Obb3, relate_round)
PLUMB_PAIR_ANSWERS_TO(ConvexPolyhedron3, relate_round, Sphere3, Capsule3, Lozenge3)
PLUMB_PAIR_ANSWERS_TO(Capsule3, relate_round, Point3, Segment3, Triangle3, Rectangle3, Tetrahedron3, Aabb3, Obb3,
                      Sphere3)
PLUMB_PAIR_ANSWERS_TO(Lozenge3, relate_round, Point3, Segment3, Triangle3, Rectangle3, Tetrahedron3, Aabb3, Obb3,
                      Sphere3, Capsule3)

}  // namespace query
}  // namespace plumb
