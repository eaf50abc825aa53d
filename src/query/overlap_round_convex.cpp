// Balls, capsules and lozenges against convex shapes that are given by vertices.
#include "exact_gap.hpp"
#include "plumb/query/overlap_round.hpp"
#include "round_input.hpp"
#include "round_vertices.hpp"

namespace plumb {
namespace query {
namespace {

bool may_be_empty(const Aabb3& box) { return box.min.x > box.max.x || box.min.y > box.max.y || box.min.z > box.max.z; }
bool may_be_empty(const ConvexPolyhedron3& polyhedron) { return polyhedron.mesh.vertices.empty(); }
bool may_be_empty(const auto&) { return false; }

template <class Flat, class Round>
std::optional<Sign> quick(const Flat& flat, const Round& round) {
  if (!is_sound(flat) || !is_sound(round) || may_be_empty(flat)) return {};
  return quick_gap(vertices(flat), vertices(round), 0, round.radius);
}

/// Of a flat shape and a round one; `swapped` says that the round one is the argument a.
template <class Flat, class Round>
Relation relate_vertices(const Flat& flat, const Round& round, bool swapped = false) {
  if (const auto gap = quick(flat, round)) [[likely]]
    return static_cast<Relation>(-*gap);
  Input("relate", swapped ? "b" : "a").require(flat);
  Input("relate", swapped ? "a" : "b").require(round);
  return relate_swept(core_set(round), round.radius, flat_set(flat));
}

template <class A, class B>
Relation relate_round(const A& a, const B& b) {
  if (is_sound(a) && is_sound(b)) [[likely]] {
    if (const auto gap = quick_gap(vertices(a), vertices(b), a.radius, b.radius)) [[likely]]
      return static_cast<Relation>(-*gap);
  }
  require_shapes_of("relate", a, b);
  return relate_swept(core_set(a), a.radius, core_set(b), b.radius);
}

}  // namespace
}  // namespace query

using query::relate_vertices, query::relate_round;

Relation relate(const Triangle3& a, const Sphere3& b) { return relate_vertices(a, b); }
Relation relate(const Rectangle3& a, const Sphere3& b) { return relate_vertices(a, b); }
Relation relate(const Tetrahedron3& a, const Sphere3& b) { return relate_vertices(a, b); }
Relation relate(const Sphere3& a, const Obb3& b) { return relate_vertices(b, a, true); }
Relation relate(const Sphere3& a, const ConvexPolyhedron3& b) { return relate_vertices(b, a, true); }

Relation relate(const Point3& a, const Capsule3& b) { return relate_vertices(a, b); }
Relation relate(const Segment3& a, const Capsule3& b) { return relate_vertices(a, b); }
Relation relate(const Triangle3& a, const Capsule3& b) { return relate_vertices(a, b); }
Relation relate(const Rectangle3& a, const Capsule3& b) { return relate_vertices(a, b); }
Relation relate(const Tetrahedron3& a, const Capsule3& b) { return relate_vertices(a, b); }
Relation relate(const Aabb3& a, const Capsule3& b) { return relate_vertices(a, b); }
Relation relate(const Obb3& a, const Capsule3& b) { return relate_vertices(a, b); }
Relation relate(const Capsule3& a, const ConvexPolyhedron3& b) { return relate_vertices(b, a, true); }

Relation relate(const Point3& a, const Lozenge3& b) { return relate_vertices(a, b); }
Relation relate(const Segment3& a, const Lozenge3& b) { return relate_vertices(a, b); }
Relation relate(const Triangle3& a, const Lozenge3& b) { return relate_vertices(a, b); }
Relation relate(const Rectangle3& a, const Lozenge3& b) { return relate_vertices(a, b); }
Relation relate(const Tetrahedron3& a, const Lozenge3& b) { return relate_vertices(a, b); }
Relation relate(const Aabb3& a, const Lozenge3& b) { return relate_vertices(a, b); }
Relation relate(const Obb3& a, const Lozenge3& b) { return relate_vertices(a, b); }
Relation relate(const Lozenge3& a, const ConvexPolyhedron3& b) { return relate_vertices(b, a, true); }

Relation relate(const Sphere3& a, const Capsule3& b) { return relate_round(a, b); }
Relation relate(const Sphere3& a, const Lozenge3& b) { return relate_round(a, b); }
Relation relate(const Capsule3& a, const Lozenge3& b) { return relate_round(a, b); }

}  // namespace plumb
