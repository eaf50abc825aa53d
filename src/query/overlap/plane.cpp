#include "plumb/certify/direction.hpp"
#include "plumb/predicates/plane_distance.hpp"
#include "query/body/figure_input.hpp"
#include "query/convex/flat_set.hpp"
#include "query/overlap/pair_answer.hpp"
#include "query/overlap/shapes3.hpp"
#include "query/overlap/signs.hpp"

namespace plumb {
namespace query {
namespace {

using SignTriple = std::array<Sign, 3>;

// The least and the most of the signs that points of a shape have to a plane.
struct PlaneSides {
  Sign low, high;

  void add(Sign s) {
    low = least(low, s);
    high = most(high, s);
  }
};

Relation of_plane(const PlaneSides& s) {
  if (s.low == s.high) return s.low == Sign::zero ? Relation::overlapping : Relation::disjoint;
  return s.low * s.high == Sign::negative ? Relation::overlapping : Relation::touching;
}

Sign side(const Plane3& plane, const Point3& p) {
  return sign_of(predicates::SideOfPlane{}, plane.normal, plane.offset, p);
}
Sign side(const ThreePointPlane3& plane, const Point3& p) { return -orient3d(plane.a, plane.b, plane.c, p); }

/// Of two points at once, by their coordinates: -1, 0 or 1, where 0 is what doubles do not tell.
struct TwoSides {
  int first, second;
};
[[gnu::always_inline]] inline TwoSides quick_sides(const Plane3& plane, TwoDoubles x, TwoDoubles y, TwoDoubles z) {
  using predicates::SideOfPlane;
  using Input = FilteredTwo::Input;
  const auto both = [](double a) { return Input{TwoDoubles{a, a}}; };
  const auto& n = plane.normal;
  const FilteredTwo sides =
      SideOfPlane{}(std::array{both(n.x), both(n.y), both(n.z), both(plane.offset), Input{x}, Input{y}, Input{z}});
  const TwoDoubles error = filter_constant<SideOfPlane>() * sides.magnitude;
  return {beyond(sides.value[0], error[0]), beyond(sides.value[1], error[1])};
}

SignTriple negated(const SignTriple& s) { return {-s[0], -s[1], -s[2]}; }

SignTriple normal(const Plane3& plane) {
  return {order(plane.normal.x, 0), order(plane.normal.y, 0), order(plane.normal.z, 0)};
}
SignTriple normal(const ThreePointPlane3& plane) {
  const auto seen_along = [&](std::size_t k) { return orient2d(seen(plane.a, k), seen(plane.b, k), seen(plane.c, k)); };
  return {seen_along(0), seen_along(1), seen_along(2)};
}
bool is_plane(const ThreePointPlane3& plane) { return telling_axis({plane.a, plane.b, plane.c}) != 3; }

// Along the normal of a box's farthest corner: center + sum of t_i axes_i, whose factors have the signs for it.
struct CornerSide {
  static constexpr std::string_view name = "relate";
  static constexpr std::array arguments{3, 1, 3, 3, 3, 3, 3};
  static constexpr bool homogeneous = false;
  template <class T>
  constexpr auto operator()(const std::array<T, 19>& p) const {
    const auto along = [&](std::size_t i) { return p[0] * p[i] + p[1] * p[i + 1] + p[2] * p[i + 2]; };
    return (along(4) - p[3]) + (p[16] * along(7) + p[17] * along(10) + p[18] * along(13));
  }
};
struct CornerOverPlane {
  static constexpr std::string_view name = "relate";
  static constexpr std::array arguments{3, 3, 3, 3, 3, 3, 3, 3};
  static constexpr bool homogeneous = false;
  template <class T>
  constexpr auto operator()(const std::array<T, 24>& p) const {
    using predicates::argument, predicates::difference;
    const auto n = predicates::cross(difference(p, 0, 1), difference(p, 0, 2));
    const auto along = [&](std::size_t i) { return predicates::dot(argument(p, i), n); };
    return predicates::dot(difference(p, 0, 3), n) + (p[21] * along(4) + p[22] * along(5) + p[23] * along(6));
  }
};

Sign corner_side(const Plane3& plane, const Obb3& box, const Vector3& by) {
  return sign_of(CornerSide{}, plane.normal, plane.offset, box.center, box.axes[0], box.axes[1], box.axes[2], by);
}
Sign corner_side(const ThreePointPlane3& plane, const Obb3& box, const Vector3& by) {
  return sign_of(CornerOverPlane{}, plane.a, plane.b, plane.c, box.center, box.axes[0], box.axes[1], box.axes[2], by);
}
Sign along_normal(const Plane3& plane, const Vector3& v) { return dot_sign(plane.normal, v); }
Sign along_normal(const ThreePointPlane3& plane, const Vector3& v) {
  return sign_of(predicates::OrientSeenFrom{}, v, plane.a, plane.b, plane.c);
}

// Both sides, or the lower one as both where the upper one does not matter.
template <class Plane>
PlaneSides sides(const Plane& plane, const Aabb3& box, bool both) {
  const SignTriple n = normal(plane);
  const Sign low = side(plane, corner(box, negated(n)));
  return {low, both && low != Sign::positive ? side(plane, corner(box, n)) : low};
}
template <class Plane>
PlaneSides sides(const Plane& plane, const Obb3& box, bool both) {
  const auto outward = [&](std::size_t i, double half) {
    return along_normal(plane, box.axes[i]) == Sign::negative ? -magnitude_of(half) : magnitude_of(half);
  };
  const Vector3 by{outward(0, box.half.x), outward(1, box.half.y), outward(2, box.half.z)};
  const Sign low = corner_side(plane, box, {-by.x, -by.y, -by.z});
  return {low, both && low != Sign::positive ? corner_side(plane, box, by) : low};
}
template <class Plane>
PlaneSides sides(const Plane& plane, const Point3& p, bool) {
  const Sign s = side(plane, p);
  return {s, s};
}
template <class Plane>
PlaneSides sides(const Plane& plane, const Segment3& t, bool both) {
  PlaneSides s = sides(plane, t.a, both);
  s.add(side(plane, t.b));
  return s;
}
template <class Plane>
PlaneSides sides(const Plane& plane, const Triangle3& t, bool both) {
  PlaneSides s = sides(plane, Segment3{t.a, t.b}, both);
  s.add(side(plane, t.c));
  return s;
}
template <class Plane>
PlaneSides sides(const Plane& plane, const Tetrahedron3& t, bool both) {
  PlaneSides s = sides(plane, Triangle3{t.a, t.b, t.c}, both);
  s.add(side(plane, t.d));
  return s;
}

template <class Shape>
Relation relate_plane(const Plane3& plane, const Shape& s) {
  return is_nothing(s) ? Relation::disjoint : of_plane(sides(plane, s, true));
}
template <class Shape>
Relation relate_plane(const ThreePointPlane3& plane, const Shape& s) {
  if (is_nothing(s)) return Relation::disjoint;
  const PlaneSides found = sides(plane, s, true);
  // Of no plane at all every sign is zero.
  if (found.low == Sign::zero && found.high == Sign::zero && !is_plane(plane))
    return relate(flat_set(plane), flat_set(s));
  return of_plane(found);
}
template <class Shape>
Relation relate_plane(const Halfspace3& half, const Shape& s) {
  if (is_nothing(s)) return Relation::disjoint;
  if (half.normal == Vector3{0, 0, 0}) return half.offset < 0 ? Relation::disjoint : Relation::overlapping;
  return relation(-sides(Plane3{half.normal, half.offset}, s, false).low);
}

template <class A, class B>
Relation relate_to_plane(const A& a, const B& b, Question question) {
  require_figures(question, a, b);
  if constexpr (requires { relate_plane(a, b); }) {
    return relate_plane(a, b);
  } else {
    return relate_plane(b, a);
  }
}

/// What doubles do not tell, out of line.
template <class B>
[[gnu::noinline, gnu::cold]] Relation relate_slowly(const Plane3& a, const B& b, Question question) {
  return relate_to_plane(a, b, question);
}

}  // namespace
PLUMB_PAIR_ANSWERS_TO(Plane3, relate_to_plane, Point3, Segment3)
Relation relate_pair(PairFunction<Plane3, Triangle3>, const Plane3& a, const Triangle3& b, Question question) {
  assert_sound_thread();
  const auto [p, q] = quick_sides(a, TwoDoubles{b.a.x, b.b.x}, TwoDoubles{b.a.y, b.b.y}, TwoDoubles{b.a.z, b.b.z});
  const int r = quick_sides(a, TwoDoubles{b.c.x, b.c.x}, TwoDoubles{b.c.y, b.c.y}, TwoDoubles{b.c.z, b.c.z}).first;
  if (p * q * r == 0) return relate_slowly(a, b, question);
  return static_cast<Relation>(1 - 2 * static_cast<int>(p == q) * static_cast<int>(q == r));
}
PLUMB_PAIR_ANSWER(Plane3, Tetrahedron3, relate_to_plane)
Relation relate_pair(PairFunction<Plane3, Aabb3>, const Plane3& a, const Aabb3& b, Question question) {
  assert_sound_thread();
  // The corner that is lowest along the normal, and the highest.
  const auto ends = [](double along, double min, double max) {
    return TwoDoubles{along, along} > 0 ? TwoDoubles{min, max} : TwoDoubles{max, min};
  };
  const auto [low, high] = quick_sides(a, ends(a.normal.x, b.min.x, b.max.x), ends(a.normal.y, b.min.y, b.max.y),
                                       ends(a.normal.z, b.min.z, b.max.z));
  const int are_alike = low * high;
  if (are_alike == 0 || is_empty(b)) return relate_slowly(a, b, question);
  return static_cast<Relation>(-are_alike);
}
PLUMB_PAIR_ANSWER(Plane3, Obb3, relate_to_plane)
PLUMB_PAIR_ANSWERS_TO(ThreePointPlane3, relate_to_plane, Point3, Segment3)
PLUMB_PAIR_ANSWERS_OF(ThreePointPlane3, relate_to_plane, Triangle3, Tetrahedron3, Aabb3, Obb3)
PLUMB_PAIR_ANSWERS_TO(Halfspace3, relate_to_plane, Point3, Segment3)
PLUMB_PAIR_ANSWERS_OF(Halfspace3, relate_to_plane, Triangle3, Tetrahedron3, Aabb3, Obb3)

}  // namespace query
}  // namespace plumb
