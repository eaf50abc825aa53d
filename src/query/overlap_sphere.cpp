// A ball against what its nearest point is soon found on: lines, rays, segments, axis-aligned boxes.
#include <algorithm>
#include <plumb/predicates/distance.hpp>
#include <plumb/predicates/line_distance.hpp>

#include "exact_gap.hpp"
#include "figure/vec.hpp"
#include "figure_input.hpp"
#include "plumb/certify/compare_distance.hpp"
#include "plumb/query/overlap_round.hpp"

namespace plumb {
namespace query {
namespace {

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
  return gap(Point3{std::clamp(x, a.min.x, a.max.x), std::clamp(y, a.min.y, a.max.y), std::clamp(z, a.min.z, a.max.z)},
             b);
}

/// (a, b, center): how far along the segment the center lies.
struct AlongSegment {
  static constexpr std::string_view name = "relate";
  static constexpr std::array arguments{3, 3, 3};
  template <class T>
  constexpr auto operator()(const std::array<T, 9>& p) const {
    return predicates::dot(predicates::difference(p, 0, 2), predicates::difference(p, 0, 1));
  }
};

/// The filters of how far along the center is, and of its distance from the line and from an end, with bounds of their
/// magnitudes that cost less: with W and D the squares of w and d, |w_i d_i| <= (w_i^2 + d_i^2) / 2, so that w . d has
/// no more than (W + D) / 2, and (w x d)^2 no more than 2 W D.  The guards of a product of two squares add up to less
/// than `tiny` times both and `guard`, those of a square to less than `guard`; what the bounds round is less than
/// `more`.
inline constexpr double more = 1 + 0x1p-40, guard = 0x1p-900, tiny = 0x1p-1000;
inline constexpr double along_constant = filter_constant<AlongSegment>() / 2 * more,
                        line_constant = filter_constant<predicates::LineDistanceAgainst3d>() * more,
                        point_constant = filter_constant<predicates::DistanceAgainst3d>() * more;
static_assert(filter_constant<Along>() <= filter_constant<AlongSegment>() &&
              filter_constant<LineGap>() <= filter_constant<predicates::LineDistanceAgainst3d>());

using core::Plain;

/// Of the points from + t d, t from 0 up to 1 where they have an end, of which w leads from the first to the center.
template <bool has_end>
std::optional<Sign> quick_line(const Plain& w, const Plain& d, const Point3& end, const Sphere3& b) {
  const double along = core::dot(w, d), size = core::dot(d, d), square = core::dot(w, w), reach = b.radius * b.radius;
  const double doubt = along_constant * (square + size) + guard;
  const auto answer = [](int gap, bool nearest) {
    return gap != 0 && nearest ? std::optional(static_cast<Sign>(gap)) : std::nullopt;
  };
  if (!(along > 0)) {
    const int gap = beyond(square - reach, point_constant * (square + reach) + guard);
    return answer(gap, gap < 0 || along < -doubt);
  }
  if (has_end && !(along < size)) {
    const Plain v{b.center.x - end.x, b.center.y - end.y, b.center.z - end.z};
    const double rest = core::dot(v, v);
    const int gap = beyond(rest - reach, point_constant * (rest + reach) + guard);
    return answer(gap, gap < 0 || core::dot(v, d) > along_constant * (rest + size) + guard);
  }
  const Plain off = core::cross(w, d);
  const double off_line = core::dot(off, off), limit = reach * size;
  const int gap =
      beyond(off_line - limit, line_constant * (2 * square * size + limit) + tiny * (square + size + reach) + guard);
  // The size is off by no more than twice the doubt.
  return answer(gap, gap > 0 || (along > doubt && (!has_end || size - along > 3 * doubt)));
}

/// What doubles prove, if anything.
Plain plain(const Point3& from, const Point3& to) { return {to.x - from.x, to.y - from.y, to.z - from.z}; }
std::optional<Sign> quick(const Ray3& a, const Sphere3& b) {
  const auto& [x, y, z] = a.direction;
  return quick_line<false>(plain(a.origin, b.center), {x, y, z}, a.origin, b);
}
std::optional<Sign> quick(const Segment3& a, const Sphere3& b) {
  return quick_line<true>(plain(a.a, b.center), plain(a.a, a.b), a.b, b);
}
std::optional<Sign> quick(const auto&, const Sphere3&) { return {}; }

template <class Flat>
Relation relate_nearest(const Flat& flat, const Sphere3& ball, Asked asked) {
  require_figures(asked, flat, ball);
  if (is_nothing(flat)) return Relation::disjoint;
  if (const auto g = quick(flat, ball)) return static_cast<Relation>(-*g);
  const Sign s = gap(flat, ball);
  if (s == Sign::zero && ball.radius == 0) return relate_swept(core_set(ball), 0, flat_set(flat));
  return static_cast<Relation>(-s);
}

}  // namespace
}  // namespace query

Relation relate(const Point3& a, const Sphere3& b, Asked asked) { return query::relate_nearest(a, b, asked); }
Relation relate(const Line3& a, const Sphere3& b, Asked asked) { return query::relate_nearest(a, b, asked); }
Relation relate(const Ray3& a, const Sphere3& b, Asked asked) { return query::relate_nearest(a, b, asked); }
Relation relate(const Segment3& a, const Sphere3& b, Asked asked) { return query::relate_nearest(a, b, asked); }

namespace round_overlap {

Relation relate_exactly(const Sphere3& a, const Aabb3& b, Asked asked) { return query::relate_nearest(b, a, asked); }

}  // namespace round_overlap

}  // namespace plumb
