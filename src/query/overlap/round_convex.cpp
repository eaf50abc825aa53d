// Balls, capsules and lozenges against convex shapes that are given by vertices.
#include "figure/support/near_points.hpp"
#include "query/body/figure_input.hpp"
#include "query/convex/core.hpp"
#include "query/convex/exact_gap.hpp"
#include "query/convex/round_vertices.hpp"
#include "query/overlap/box_quick.hpp"
#include "query/overlap/pair_answer.hpp"

namespace plumb {
namespace query {
namespace {

using figure::near_points::quick_gap, query::quick_gap;

std::optional<Sign> near_or_far(const Triangle3& t, const Sphere3& b) { return quick_gap(t, b.center, b.radius); }
std::optional<Sign> near_or_far(const Obb3& box, const Sphere3& b) {
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
std::optional<Sign> gap_of_vertices(const A& a, double radius_a, const B& b, double radius_b) {
  LikelyEnds likely;
  if (const auto gap = quick_gap(query::vertices(a), query::vertices(b), radius_a, radius_b, &likely)) [[likely]]
    return gap;
  return integer_gap(query::vertices<ShortDyadic>(a), query::vertices<ShortDyadic>(b), radius_a, radius_b, likely);
}

template <class Flat, class Round>
[[gnu::noinline]] Relation relate_slowly(const Flat& flat, const Round& round, Question question) {
  if (is_sound(flat) && is_sound(round) && !is_nothing(flat)) {
    if (const auto gap = gap_of_vertices(flat, 0, round, round.radius)) [[likely]]
      return static_cast<Relation>(-*gap);
  }
  require_figures(question, flat, round);
  return relate_swept(core_of(round), round.radius, flat_set(flat));
}

template <class Flat, class Round>
Relation relate_vertices(const Flat& flat, const Round& round, Question question) {
  if constexpr (requires { near_or_far(flat, round); }) {
    if (const auto gap = near_or_far(flat, round)) [[likely]]
      return static_cast<Relation>(-*gap);
  }
  return relate_slowly(flat, round, question);
}

template <class Round, class Flat>
Relation relate_vertices_of_other(const Round& round, const Flat& flat, Question question) {
  return relate_vertices(flat, round, question);
}

template <class A, class B>
Relation relate_round(const A& a, const B& b, Question question) {
  if (is_sound(a) && is_sound(b)) [[likely]] {
    if (const auto gap = gap_of_vertices(a, a.radius, b, b.radius)) [[likely]]
      return static_cast<Relation>(-*gap);
  }
  require_figures(question, a, b);
  return relate_swept(core_of(a), a.radius, core_of(b), b.radius);
}

}  // namespace
PLUMB_PAIR_ANSWER(Triangle3, Sphere3, relate_vertices)
PLUMB_PAIR_ANSWER(Rectangle3, Sphere3, relate_vertices)
PLUMB_PAIR_ANSWER(Tetrahedron3, Sphere3, relate_vertices)
PLUMB_PAIR_ANSWER(Sphere3, Obb3, relate_vertices_of_other)
PLUMB_PAIR_ANSWER(Sphere3, ConvexPolyhedron3, relate_vertices_of_other)

PLUMB_PAIR_ANSWER(Point3, Capsule3, relate_vertices)
PLUMB_PAIR_ANSWER(Segment3, Capsule3, relate_vertices)
PLUMB_PAIR_ANSWER(Triangle3, Capsule3, relate_vertices)
PLUMB_PAIR_ANSWER(Rectangle3, Capsule3, relate_vertices)
PLUMB_PAIR_ANSWER(Tetrahedron3, Capsule3, relate_vertices)
PLUMB_PAIR_ANSWER(Aabb3, Capsule3, relate_vertices)
PLUMB_PAIR_ANSWER(Obb3, Capsule3, relate_vertices)
PLUMB_PAIR_ANSWER(Capsule3, ConvexPolyhedron3, relate_vertices_of_other)

PLUMB_PAIR_ANSWER(Point3, Lozenge3, relate_vertices)
PLUMB_PAIR_ANSWER(Segment3, Lozenge3, relate_vertices)
PLUMB_PAIR_ANSWER(Triangle3, Lozenge3, relate_vertices)
PLUMB_PAIR_ANSWER(Rectangle3, Lozenge3, relate_vertices)
PLUMB_PAIR_ANSWER(Tetrahedron3, Lozenge3, relate_vertices)
PLUMB_PAIR_ANSWER(Aabb3, Lozenge3, relate_vertices)
PLUMB_PAIR_ANSWER(Obb3, Lozenge3, relate_vertices)
PLUMB_PAIR_ANSWER(Lozenge3, ConvexPolyhedron3, relate_vertices_of_other)

PLUMB_PAIR_ANSWER(Sphere3, Capsule3, relate_round)
PLUMB_PAIR_ANSWER(Sphere3, Lozenge3, relate_round)
PLUMB_PAIR_ANSWER(Capsule3, Lozenge3, relate_round)

}  // namespace query
}  // namespace plumb
