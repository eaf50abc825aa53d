// Balls, capsules and lozenges against convex shapes that are given by vertices.
#include "figure/support/near_points.hpp"
#include "plumb/query/overlap/round.hpp"
#include "query/body/figure_input.hpp"
#include "query/convex/exact_gap.hpp"
#include "query/convex/round_vertices.hpp"

namespace plumb {
namespace query {
namespace {

using figure::near_points::quick_gap, query::quick_gap;

std::optional<Sign> near_or_far(const Triangle3& t, const Sphere3& b) { return quick_gap(t, b.center, b.radius); }
std::optional<Sign> near_or_far(const Obb3& box, const Sphere3& b) { return quick_gap(box, b.center, b.radius); }
std::optional<Sign> near_or_far(const Segment3& s, const Capsule3& c) {
  return quick_gap(s, Segment3{c.a, c.b}, 0, c.radius);
}
std::optional<Sign> near_or_far(const Aabb3& box, const Capsule3& c) {
  if (!is_sound(box) || !is_sound(c) || is_empty(box)) return {};
  return quick_gap(box, Segment3{c.a, c.b}, c.radius);
}

template <class Flat, class Round>
[[gnu::noinline]] Relation relate_slowly(const Flat& flat, const Round& round, Asked asked) {
  if (is_sound(flat) && is_sound(round) && !is_nothing(flat)) {
    if (const auto gap = quick_gap(query::vertices(flat), query::vertices(round), 0, round.radius)) [[likely]]
      return static_cast<Relation>(-*gap);
  }
  require_figures(asked, flat, round);
  return relate_swept(core_set(round), round.radius, flat_set(flat));
}

template <class Flat, class Round>
Relation relate_vertices(const Flat& flat, const Round& round, Asked asked) {
  if constexpr (requires { near_or_far(flat, round); }) {
    if (const auto gap = near_or_far(flat, round)) [[likely]]
      return static_cast<Relation>(-*gap);
  }
  return relate_slowly(flat, round, asked);
}

template <class A, class B>
Relation relate_round(const A& a, const B& b, Asked asked) {
  if (is_sound(a) && is_sound(b)) [[likely]] {
    if (const auto gap = quick_gap(query::vertices(a), query::vertices(b), a.radius, b.radius)) [[likely]]
      return static_cast<Relation>(-*gap);
  }
  require_figures(asked, a, b);
  return relate_swept(core_set(a), a.radius, core_set(b), b.radius);
}

}  // namespace
}  // namespace query

using query::relate_vertices, query::relate_round;

Relation relate(const Triangle3& a, const Sphere3& b, Asked asked) { return relate_vertices(a, b, asked); }
Relation relate(const Rectangle3& a, const Sphere3& b, Asked asked) { return relate_vertices(a, b, asked); }
Relation relate(const Tetrahedron3& a, const Sphere3& b, Asked asked) { return relate_vertices(a, b, asked); }
Relation relate(const Sphere3& a, const Obb3& b, Asked asked) { return relate_vertices(b, a, asked); }
Relation relate(const Sphere3& a, const ConvexPolyhedron3& b, Asked asked) { return relate_vertices(b, a, asked); }

Relation relate(const Point3& a, const Capsule3& b, Asked asked) { return relate_vertices(a, b, asked); }
Relation relate(const Segment3& a, const Capsule3& b, Asked asked) { return relate_vertices(a, b, asked); }
Relation relate(const Triangle3& a, const Capsule3& b, Asked asked) { return relate_vertices(a, b, asked); }
Relation relate(const Rectangle3& a, const Capsule3& b, Asked asked) { return relate_vertices(a, b, asked); }
Relation relate(const Tetrahedron3& a, const Capsule3& b, Asked asked) { return relate_vertices(a, b, asked); }
Relation relate(const Aabb3& a, const Capsule3& b, Asked asked) { return relate_vertices(a, b, asked); }
Relation relate(const Obb3& a, const Capsule3& b, Asked asked) { return relate_vertices(a, b, asked); }
Relation relate(const Capsule3& a, const ConvexPolyhedron3& b, Asked asked) { return relate_vertices(b, a, asked); }

Relation relate(const Point3& a, const Lozenge3& b, Asked asked) { return relate_vertices(a, b, asked); }
Relation relate(const Segment3& a, const Lozenge3& b, Asked asked) { return relate_vertices(a, b, asked); }
Relation relate(const Triangle3& a, const Lozenge3& b, Asked asked) { return relate_vertices(a, b, asked); }
Relation relate(const Rectangle3& a, const Lozenge3& b, Asked asked) { return relate_vertices(a, b, asked); }
Relation relate(const Tetrahedron3& a, const Lozenge3& b, Asked asked) { return relate_vertices(a, b, asked); }
Relation relate(const Aabb3& a, const Lozenge3& b, Asked asked) { return relate_vertices(a, b, asked); }
Relation relate(const Obb3& a, const Lozenge3& b, Asked asked) { return relate_vertices(a, b, asked); }
Relation relate(const Lozenge3& a, const ConvexPolyhedron3& b, Asked asked) { return relate_vertices(b, a, asked); }

Relation relate(const Sphere3& a, const Capsule3& b, Asked asked) { return relate_round(a, b, asked); }
Relation relate(const Sphere3& a, const Lozenge3& b, Asked asked) { return relate_round(a, b, asked); }
Relation relate(const Capsule3& a, const Lozenge3& b, Asked asked) { return relate_round(a, b, asked); }

}  // namespace plumb
