// Balls, capsules, lozenges, cylinders and cones against planes and halfspaces: how far they reach along the normal.
#include "arith/approximate.hpp"
#include "arith/certain.hpp"
#include "arith/running_error.hpp"
#include "figure/swept_sphere/core_distance.hpp"
#include "plumb/certify/direction.hpp"
#include "plumb/figure/containment/contains.hpp"
#include "plumb/predicates/plane_distance.hpp"
#include "query/body/axis_shape.hpp"
#include "query/body/figure_input.hpp"
#include "query/convex/core.hpp"
#include "query/convex/exact_gap.hpp"
#include "query/overlap/pair_answer.hpp"

namespace plumb {
namespace query {
namespace {

template <class T>
using Vec = arith::Vec<T>;

/// A shape is the hull of disks or balls around centers, each of which reaches along the normal n by the root of
/// reach / square; of a cone only the last one does.
template <class T>
struct ExtentAlong {
  T reach, square;  // square is above zero
};

template <class T>
T squared(const T& x) {
  return x * x;
}

template <class T>
std::array<Vec<T>, 1> centers(const Sphere3& s) {
  return {arith::vec<T>(s.center)};
}
template <class T>
std::array<Vec<T>, 2> centers(const Capsule3& c) {
  return {arith::vec<T>(c.a), arith::vec<T>(c.b)};
}
template <class T>
std::array<Vec<T>, 4> centers(const Lozenge3& l) {
  const Vec<T> corner = arith::vec<T>(l.corner), e = arith::vec<T>(l.edges[0]), f = arith::vec<T>(l.edges[1]);
  return {corner, corner + e, corner + f, corner + e + f};
}
template <class T>
std::array<Vec<T>, 2> centers(const Cylinder3& c) {
  return {arith::vec<T>(c.a), arith::vec<T>(c.b)};
}
template <class T>
std::array<Vec<T>, 2> centers(const Cone3& c) {
  return {arith::vec<T>(c.apex), arith::vec<T>(c.base)};
}

template <class T, class Round>
ExtentAlong<T> reach_along(const Round& round, const Vec<T>& n) {
  const T r = squared(T(round.radius));
  if constexpr (std::is_same_v<Round, Cylinder3> || std::is_same_v<Round, Cone3>) {  // a disk across h: |n x h| / |h|
    const auto [from, to] = centers<T>(round);
    const Vec<T> h = to - from, across = arith::cross(n, h);
    return {r * arith::dot(across, across), arith::dot(h, h)};
  } else {
    return {r * arith::dot(n, n), T(1.0)};
  }
}

/// All x with height(x) = normal . x - offset = 0.
template <class T>
struct PlaneOver {
  Vec<T> normal;
  T offset;
  T height(const Vec<T>& x) const { return dot(normal, x) - offset; }
};
/// Through a point: differences of what is near are small.
template <class T>
struct PlaneThrough {
  Vec<T> normal, from;
  T height(const Vec<T>& x) const { return dot(normal, x - from); }
};
template <class T>
PlaneOver<T> plane_over(const auto& plane) {
  return {arith::vec<T>(plane.normal), T(plane.offset)};
}
template <class T>
PlaneOver<T> plane_over(const ExactPlane& plane) {
  return {plane.normal, plane.offset};
}
template <class T>
PlaneThrough<T> plane_over(const ThreePointPlane3& plane) {
  const Vec<T> a = arith::vec<T>(plane.a);
  return {arith::cross(arith::vec<T>(plane.b) - a, arith::vec<T>(plane.c) - a), a};
}

/// The sign of height - root of (reach / square), or of the height alone.
template <class T>
Sign beyond_plane(const T& height, const ExtentAlong<T>* r, CertainSigns& ask) {
  if (r == nullptr) return ask(height);
  const Sign difference = ask(squared(height) * r->square - r->reach);
  if (difference == Sign::negative) return Sign::negative;  // as |height| is the lesser
  const Sign side = ask(height);
  return side == Sign::positive ? difference : side == Sign::zero ? -ask(r->reach) : Sign::negative;
}

/// Above the plane, below it, or on both sides; zero where it touches from a side.
struct RoundSides {
  Sign above, below;
};
template <class T, class Plane, class Round>
std::optional<RoundSides> sides_of(const Plane& plane, const Round& round) {
  CertainSigns ask;
  const auto p = plane_over<T>(plane);
  RoundSides all{Sign::positive, Sign::positive};
  const ExtentAlong<T> reach = reach_along<T>(round, p.normal);
  bool is_point = std::is_same_v<Round, Cone3>;  // the apex
  for (const Vec<T>& center : centers<T>(round)) {
    const T height = p.height(center);
    const ExtentAlong<T>* of_center = is_point ? nullptr : &reach;
    all.above = std::min(all.above, beyond_plane(height, of_center, ask));
    if constexpr (!std::is_same_v<Plane, Halfspace3>)
      all.below = std::min(all.below, beyond_plane(T(0.0) - height, of_center, ask));
    is_point = false;
  }
  if (!ask.certain()) return {};
  return all;
}

/// What doubles prove: a center beyond the halfspace or centers on both sides of the plane, else how far disks reach.
template <class Plane, class Round>
[[gnu::flatten]] std::optional<Relation> quick(const Plane& plane, const Round& round) {
  constexpr bool of_halfspace = std::is_same_v<Plane, Halfspace3>, of_cone = std::is_same_v<Round, Cone3>;
  const auto p = plane_over<Approximate>(plane);
  const auto at = centers<Approximate>(round);
  constexpr std::size_t n = std::tuple_size_v<decltype(at)>;
  const std::array<Approximate, n> heights = [&]<std::size_t... I>(std::index_sequence<I...>) {
    return std::array{p.height(at[I])...};
  }
  (std::make_index_sequence<n>{});
  bool all_above = true, all_below = true, some_above = false, some_below = false;
  for (const Approximate& h : heights) {
    const int side = h.certain_sign();
    all_above = all_above & (side > 0), some_above = some_above | (side > 0);
    all_below = all_below & (side < 0), some_below = some_below | (side < 0);
  }
  if (some_below && (of_halfspace || some_above)) return Relation::overlapping;
  const ExtentAlong<Approximate> reach = reach_along<Approximate>(round, p.normal);
  bool all_far = all_above || all_below;
  for (std::size_t i = of_cone ? 1 : 0; i < n; ++i) {  // the apex of a cone is a point
    const int gap = (squared(heights[i]) * reach.square - reach.reach).certain_sign();
    if (gap < 0) return Relation::overlapping;
    all_far = all_far & (gap > 0);
  }
  if (all_far) return Relation::disjoint;
  return {};
}

Relation relation_of(const RoundSides& s, bool of_halfspace) {
  return static_cast<Relation>(-(of_halfspace ? s.above : std::max(s.above, s.below)));
}

/// Is there a plane, with two sides?
bool has_sides(const auto& plane) { return plane.normal.x != 0 || plane.normal.y != 0 || plane.normal.z != 0; }
bool has_sides(const ThreePointPlane3& plane) { return !collinear(plane.a, plane.b, plane.c); }

/// The shape where it is no ball, segment or cone of another kind in disguise.
bool is_itself(const auto& round) {
  if constexpr (requires { axis_of(round); }) {
    return axis_of(round).is_itself();
  } else {
    return round.radius > 0;
  }
}

template <class Plane, class Round>
Relation relate_round_shape(const Plane& plane, const Round& round, Question question) {
  constexpr bool of_halfspace = std::is_same_v<Plane, Halfspace3>;
  if (is_sound(plane) && is_sound(round) && is_itself(round)) [[likely]] {
    if (const auto r = quick(plane, round)) [[likely]]
      return *r;
    if (const auto sides = sides_of<Running>(plane, round)) return relation_of(*sides, of_halfspace);
  }
  require_figures(question, plane, round);
  if constexpr (requires { axis_of(round); }) {
    const auto [from, to, radius, is_cone] = axis_of(round);
    if (from == to) return relate(plane, Sphere3{from, radius});
    if (radius == 0) return relate_swept(flat_set(Segment3{from, to}), 0, flat_set(plane));
  } else if (round.radius == 0) {
    return relate_swept(core_of(round), 0, flat_set(plane));
  }
  if (has_sides(plane)) return relation_of(*sides_of<BigDyadic>(plane, round), of_halfspace);
  if constexpr (requires { axis_of(round); }) {
    if constexpr (std::is_same_v<Plane, ThreePointPlane3>) {
      if (is_point(plane)) return static_cast<Relation>(locate(round, plane.a));
      return relate_exact_line(straight<Rational>(plane), axis_of(round));
    }
    return flat_set(plane).points.empty() ? Relation::disjoint : Relation::overlapping;  // nothing or all of space
  } else {
    return relate_swept(core_of(round), round.radius, flat_set(plane));
  }
}

}  // namespace

Relation relate_exact_plane(const ExactPlane& plane, const RoundAxis& shape) {
  const auto& [from, to, radius, is_cone] = shape;
  const auto sides = is_cone ? sides_of<Rational>(plane, Cone3{from, to, radius})
                             : sides_of<Rational>(plane, Cylinder3{from, to, radius});
  return relation_of(*sides, plane.is_halfspace);
}

constinit const double plane_constant = filter_constant<predicates::NormalDistanceAgainst3d>();
static_assert(filter_constant<predicates::SideOfPlane>() <= filter_constant<predicates::NormalDistanceAgainst3d>());

PLUMB_PAIR_ANSWERS_OF(Plane3, relate_round_shape, Sphere3, Capsule3, Lozenge3, Cylinder3, Cone3)
PLUMB_PAIR_ANSWERS_OF(ThreePointPlane3, relate_round_shape, Sphere3, Capsule3, Lozenge3, Cylinder3, Cone3)
PLUMB_PAIR_ANSWERS_OF(Halfspace3, relate_round_shape, Sphere3, Capsule3, Lozenge3, Cylinder3, Cone3)

}  // namespace query
}  // namespace plumb
