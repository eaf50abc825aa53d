// Balls, capsules, lozenges, cylinders and cones against planes and halfspaces: how far they reach along the normal.
#include "axis_shape.hpp"
#include "exact_gap.hpp"
#include "plumb/certify/direction.hpp"
#include "plumb/query/overlap_cylinder_cone.hpp"
#include "plumb/query/overlap_round.hpp"
#include "round_input.hpp"
#include "running_signs.hpp"

namespace plumb {
namespace query {
namespace {

template <class T>
using Vec = core::Vec<T>;

/// The shape is the hull of disks or balls, each of which reaches from its center along the normal by reach / (square),
/// both under one root.
template <class T>
struct Reaching {
  Vec<T> center;
  T reach, square;  // reach may be zero; square is above zero
};

template <class T>
T squared(const T& x) {
  return x * x;
}

template <class T>
auto reaching(const Sphere3& s, const Vec<T>& n) {
  return std::array{Reaching<T>{core::vec<T>(s.center), squared(T(s.radius)) * dot(n, n), T(1.0)}};
}
template <class T>
auto reaching(const Capsule3& c, const Vec<T>& n) {
  const T reach = squared(T(c.radius)) * dot(n, n);
  return std::array{Reaching<T>{core::vec<T>(c.a), reach, T(1.0)}, Reaching<T>{core::vec<T>(c.b), reach, T(1.0)}};
}
template <class T>
auto reaching(const Lozenge3& l, const Vec<T>& n) {
  const T reach = squared(T(l.radius)) * dot(n, n);
  const Vec<T> corner = core::vec<T>(l.corner), e = core::vec<T>(l.edges[0]), f = core::vec<T>(l.edges[1]);
  return std::array{Reaching<T>{corner, reach, T(1.0)}, Reaching<T>{corner + e, reach, T(1.0)},
                    Reaching<T>{corner + f, reach, T(1.0)}, Reaching<T>{corner + e + f, reach, T(1.0)}};
}
// A disk across h reaches by radius |n x h| / |h|.
template <class T>
auto reaching(const Cylinder3& c, const Vec<T>& n) {
  const Vec<T> a = core::vec<T>(c.a), b = core::vec<T>(c.b), h = b - a, across = core::cross(n, h);
  const T reach = squared(T(c.radius)) * dot(across, across), square = dot(h, h);
  return std::array{Reaching<T>{a, reach, square}, Reaching<T>{b, reach, square}};
}
template <class T>
auto reaching(const Cone3& c, const Vec<T>& n) {
  const Vec<T> apex = core::vec<T>(c.apex), base = core::vec<T>(c.base), h = base - apex, across = core::cross(n, h);
  return std::array{Reaching<T>{apex, T(0.0), T(1.0)},
                    Reaching<T>{base, squared(T(c.radius)) * dot(across, across), dot(h, h)}};
}

/// All x with height(x) = normal . x - offset = 0.
template <class T>
struct PlaneOver {
  Vec<T> normal;
  Vec<T> from;  // taken from points first: differences of what is near are small
  T offset;
  T height(const Vec<T>& x) const { return dot(normal, x - from) - offset; }
};
template <class T>
PlaneOver<T> plane_over(const auto& plane) {
  return {core::vec<T>(plane.normal), {T(0.0), T(0.0), T(0.0)}, T(plane.offset)};
}
template <class T>
PlaneOver<T> plane_over(const ThreePointPlane3& plane) {
  const Vec<T> a = core::vec<T>(plane.a);
  return {core::cross(core::vec<T>(plane.b) - a, core::vec<T>(plane.c) - a), a, T(0.0)};
}

/// The sign of height - root of (reach / square).
template <class T>
Sign beyond(const T& height, const Reaching<T>& r, RunningSigns& ask) {
  const Sign difference = ask(squared(height) * r.square - r.reach);
  if (difference == Sign::negative) return Sign::negative;  // as |height| is the lesser
  const Sign side = ask(height);
  return side == Sign::positive ? difference : side == Sign::zero ? -ask(r.reach) : Sign::negative;
}

/// Above the plane, below it, or on both sides; zero where it touches from a side.
struct Sides {
  Sign above, below;
};
template <class T, class Plane, class Round>
std::optional<Sides> sides_of(const Plane& plane, const Round& round) {
  RunningSigns ask;
  const PlaneOver<T> p = plane_over<T>(plane);
  Sides all{Sign::positive, Sign::positive};
  for (const Reaching<T>& r : reaching(round, p.normal)) {
    const T height = p.height(r.center);
    all.above = std::min(all.above, beyond(height, r, ask));
    if constexpr (!std::is_same_v<Plane, Halfspace3>) all.below = std::min(all.below, beyond(T(0.0) - height, r, ask));
  }
  if (!ask.certain()) return {};
  return all;
}

Relation relation_of(const Sides& s, bool of_halfspace) {
  return static_cast<Relation>(-(of_halfspace ? s.above : std::max(s.above, s.below)));
}

/// Is there a plane, with two sides?
bool has_sides(const auto& plane) { return plane.normal.x != 0 || plane.normal.y != 0 || plane.normal.z != 0; }
bool has_sides(const ThreePointPlane3& plane) { return !collinear(plane.a, plane.b, plane.c); }

/// The shape where it is no ball, segment or cone of another kind in disguise.
bool is_itself(const Cylinder3& c) { return c.radius > 0 && c.a != c.b; }
bool is_itself(const Cone3& c) { return c.radius > 0 && c.apex != c.base; }
bool is_itself(const auto& round) { return round.radius > 0; }

template <class Plane, class Round>
Relation relate_round_shape(const Plane& plane, const Round& round) {
  constexpr bool of_halfspace = std::is_same_v<Plane, Halfspace3>;
  if (is_sound(plane) && is_sound(round) && is_itself(round)) [[likely]] {
    if (const auto sides = sides_of<Running>(plane, round)) [[likely]]
      return relation_of(*sides, of_halfspace);
  }
  require_shapes_of("relate", plane, round);
  if constexpr (std::is_same_v<Round, Cylinder3>) {
    if (round.a == round.b) return relate(plane, Sphere3{round.a, round.radius});
    if (round.radius == 0) return relate_swept(flat_set(Segment3{round.a, round.b}), 0, flat_set(plane));
  } else if constexpr (std::is_same_v<Round, Cone3>) {
    if (round.apex == round.base) return relate(plane, Sphere3{round.apex, round.radius});
    if (round.radius == 0) return relate_swept(flat_set(Segment3{round.apex, round.base}), 0, flat_set(plane));
  } else if (round.radius == 0) {
    return relate_swept(core_set(round), 0, flat_set(plane));
  }
  if (has_sides(plane)) return relation_of(*sides_of<BigDyadic>(plane, round), of_halfspace);
  if constexpr (std::is_same_v<Round, Cylinder3> || std::is_same_v<Round, Cone3>) {
    if constexpr (std::is_same_v<Plane, ThreePointPlane3>) return relate_spanned_line(plane, round);
    return flat_set(plane).points.empty() ? Relation::disjoint : Relation::overlapping;  // nothing or all of space
  } else {
    return relate_swept(core_set(round), round.radius, flat_set(plane));
  }
}

}  // namespace
}  // namespace query

using query::relate_round_shape;

Relation relate(const Plane3& a, const Sphere3& b) { return relate_round_shape(a, b); }
Relation relate(const Plane3& a, const Capsule3& b) { return relate_round_shape(a, b); }
Relation relate(const Plane3& a, const Lozenge3& b) { return relate_round_shape(a, b); }
Relation relate(const Plane3& a, const Cylinder3& b) { return relate_round_shape(a, b); }
Relation relate(const Plane3& a, const Cone3& b) { return relate_round_shape(a, b); }
Relation relate(const ThreePointPlane3& a, const Sphere3& b) { return relate_round_shape(a, b); }
Relation relate(const ThreePointPlane3& a, const Capsule3& b) { return relate_round_shape(a, b); }
Relation relate(const ThreePointPlane3& a, const Lozenge3& b) { return relate_round_shape(a, b); }
Relation relate(const ThreePointPlane3& a, const Cylinder3& b) { return relate_round_shape(a, b); }
Relation relate(const ThreePointPlane3& a, const Cone3& b) { return relate_round_shape(a, b); }
Relation relate(const Halfspace3& a, const Sphere3& b) { return relate_round_shape(a, b); }
Relation relate(const Halfspace3& a, const Capsule3& b) { return relate_round_shape(a, b); }
Relation relate(const Halfspace3& a, const Lozenge3& b) { return relate_round_shape(a, b); }
Relation relate(const Halfspace3& a, const Cylinder3& b) { return relate_round_shape(a, b); }
Relation relate(const Halfspace3& a, const Cone3& b) { return relate_round_shape(a, b); }

}  // namespace plumb
