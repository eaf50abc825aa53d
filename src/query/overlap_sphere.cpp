// A ball against what its nearest point is soon found on: lines, rays, segments, axis-aligned boxes.
#include <plumb/predicates/distance.hpp>

#include "exact_gap.hpp"
#include "figure/near_points.hpp"
#include "plumb/certify/compare_distance.hpp"
#include "plumb/query/overlap_round.hpp"
#include "round_input.hpp"

namespace plumb {
namespace query {
namespace {

using near_points::clamped, near_points::quick_gap;

/// (point, direction, center, radius): the square of the distance of a line, minus that of the radius, times that of
/// the direction.
struct LineGap {
  static constexpr std::string_view name = "relate";
  static constexpr std::array arguments{3, 3, 3, 1};
  template <class T>
  constexpr auto operator()(const std::array<T, 10>& p) const {
    using predicates::squared;
    const auto d = predicates::argument(p, 1);
    return squared(predicates::cross(predicates::difference(p, 0, 2), d)) - squared(p[9]) * squared(d);
  }
};

/// (origin, direction, center): how far along the center lies.
struct Along {
  static constexpr std::string_view name = "relate";
  static constexpr std::array arguments{3, 3, 3};
  template <class T>
  constexpr auto operator()(const std::array<T, 9>& p) const {
    return predicates::dot(predicates::difference(p, 0, 2), predicates::argument(p, 1));
  }
};

bool is_zero(const Vector3& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

Sign gap(const Point3& p, const Sphere3& b) { return sign_of(predicates::DistanceAgainst3d{}, p, b.center, b.radius); }
Sign gap(const Line3& a, const Sphere3& b) {
  if (is_zero(a.direction)) return gap(a.point, b);
  return sign_of(LineGap{}, a.point, a.direction, b.center, b.radius);
}
Sign gap(const Ray3& a, const Sphere3& b) {
  if (sign_of(Along{}, a.origin, a.direction, b.center) != Sign::positive) return gap(a.origin, b);
  return sign_of(LineGap{}, a.origin, a.direction, b.center, b.radius);
}
Sign gap(const Segment3& a, const Sphere3& b) { return compare_distance_to_segment(a.a, a.b, b.center, b.radius); }

/// Of a box that is not empty.
Sign gap(const Aabb3& a, const Sphere3& b) {
  const auto& [x, y, z] = b.center;
  return gap(Point3{clamped(x, a.min.x, a.max.x), clamped(y, a.min.y, a.max.y), clamped(z, a.min.z, a.max.z)}, b);
}

/// What doubles prove, if anything.
std::optional<Sign> quick(const Ray3& a, const Sphere3& b) { return quick_gap(a, b.center, b.radius); }
std::optional<Sign> quick(const Segment3& a, const Sphere3& b) { return quick_gap(a, b.center, b.radius); }
std::optional<Sign> quick(const auto&, const Sphere3&) { return {}; }

bool is_empty(const Aabb3& box) { return box.min.x > box.max.x || box.min.y > box.max.y || box.min.z > box.max.z; }
bool is_empty(const auto&) { return false; }

template <class Flat>
Relation relate_nearest(const Flat& flat, const Sphere3& ball, std::string_view flat_name, std::string_view ball_name) {
  if (!is_sound(flat) || !is_sound(ball)) [[unlikely]] {
    Input("relate", flat_name).require(flat);
    Input("relate", ball_name).require(ball);
  }
  if (is_empty(flat)) return Relation::disjoint;
  if (const auto g = quick(flat, ball)) return static_cast<Relation>(-*g);
  const Sign s = gap(flat, ball);
  if (s == Sign::zero && ball.radius == 0) return relate_swept(core_set(ball), 0, flat_set(flat));
  return static_cast<Relation>(-s);
}

}  // namespace
}  // namespace query

Relation relate(const Point3& a, const Sphere3& b) { return query::relate_nearest(a, b, "a", "b"); }
Relation relate(const Line3& a, const Sphere3& b) { return query::relate_nearest(a, b, "a", "b"); }
Relation relate(const Ray3& a, const Sphere3& b) { return query::relate_nearest(a, b, "a", "b"); }
Relation relate(const Segment3& a, const Sphere3& b) { return query::relate_nearest(a, b, "a", "b"); }

namespace round_overlap {

Relation relate_exactly(const Sphere3& a, const Aabb3& b) { return query::relate_nearest(b, a, "b", "a"); }

}  // namespace round_overlap

}  // namespace plumb
