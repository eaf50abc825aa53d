// A ball against what its nearest point is soon found on: lines, rays, segments, axis-aligned boxes.
#include <algorithm>

#include "arith/vec.hpp"
#include "plumb/certify/compare_distance.hpp"
#include "plumb/predicates/distance.hpp"
#include "plumb/predicates/line_distance.hpp"
#include "query/body/figure_input.hpp"
#include "query/convex/exact_gap.hpp"
#include "query/overlap/pair_answer.hpp"

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

/// (p, q, center, radius): the discriminant of the line from p to q and the ball.
struct MeetsBall {
  static constexpr std::string_view name = "relate";
  static constexpr std::array arguments{3, 3, 3, 1};
  template <class T>
  constexpr auto operator()(const std::array<T, 10>& p) const {
    const auto w = predicates::difference(p, 2, 0), d = predicates::difference(p, 0, 1);
    const auto b = predicates::dot(w, d);
    return b * b - predicates::squared(d) * (predicates::squared(w) - predicates::squared(p[9]));
  }
};

/// The filters with bounds of their magnitudes that cost less: of u . v it is the sum of the products' sizes, and that
/// squared is no more than the product of the squares.  `more` is for the roundings of the magnitude itself, the guard
/// more than all that products lose by underflow.  A direction may be a rounded difference: the constants are those of
/// differences, which are no less than those of directions as given.
inline constexpr double more = 2.125, guard = 0x1p-960;
inline constexpr double along_constant = filter_constant<AlongSegment>() * more,
                        line_constant = filter_constant<MeetsBall>() * more,
                        point_constant = filter_constant<predicates::DistanceAgainst3d>() * more;
static_assert(filter_constant<Along>() <= filter_constant<AlongSegment>());

using arith::Plain;

Plain plain(const Point3& from, const Point3& to) { return {to.x - from.x, to.y - from.y, to.z - from.z}; }
double size_of_products(const Plain& u, const Plain& v) {
  return magnitude_of(u.x * v.x) + magnitude_of(u.y * v.y) + magnitude_of(u.z * v.z);
}
/// How far a point lies beyond the ball, from the square of its distance from the center.
int beyond_ball(double square, double reach) {
  return beyond(square - reach, point_constant * (square + reach + guard));
}
/// Does the way u from the center lead away, along d?
int leads_away(const Plain& u, const Plain& d) {
  return beyond(arith::dot(u, d), along_constant * (size_of_products(u, d) + guard));
}

/// Of the points o + t d, t from 0 where they begin, and up to 1, at `end`, where they end.
template <bool begins, bool ends>
std::optional<Relation> by_doubles(const Point3& o, const Plain& d, const Point3& end, const Sphere3& ball) {
  const Plain w = plain(ball.center, o);
  const double square = arith::dot(w, w), reach = ball.radius * ball.radius, length = arith::dot(d, d);
  const double along = arith::dot(w, d), value = along * along - length * (square - reach);
  const double most = (length + guard) * (2 * square + reach + guard) + guard;
  const double doubt = line_constant * most + (value - value);
  if (!(doubt >= 0) || ball.radius < 0) return {};  // a number is none, or too large
  if (value < -doubt) return Relation::disjoint;
  const int from = beyond_ball(square, reach);
  if (begins && from < 0) return Relation::overlapping;
  if (!(value > doubt)) return {};
  if constexpr (begins) {
    const int away = leads_away(w, d);
    if (away >= 0) return away > 0 && from > 0 ? std::optional(Relation::disjoint) : std::nullopt;
    if constexpr (ends) {
      const Plain v = plain(ball.center, end);
      const int to = beyond_ball(arith::dot(v, v), reach);
      if (to < 0) return Relation::overlapping;
      const int past = leads_away(v, d);
      if (past <= 0) return past < 0 && to > 0 ? std::optional(Relation::disjoint) : std::nullopt;
    }
  }
  return Relation::overlapping;
}

std::optional<Relation> by_doubles(const Line3& a, const Sphere3& b) {
  const auto& [x, y, z] = a.direction;
  return by_doubles<false, false>(a.point, {x, y, z}, a.point, b);
}
std::optional<Relation> by_doubles(const Ray3& a, const Sphere3& b) {
  const auto& [x, y, z] = a.direction;
  return by_doubles<true, false>(a.origin, {x, y, z}, a.origin, b);
}
std::optional<Relation> by_doubles(const Segment3& a, const Sphere3& b) {
  return by_doubles<true, true>(a.a, plain(a.a, a.b), a.b, b);
}
std::optional<Relation> by_doubles(const auto&, const Sphere3&) { return {}; }

template <class Flat>
Relation relate_nearest(const Flat& flat, const Sphere3& ball, Question question) {
  assert_sound_thread();
  if (const auto told = by_doubles(flat, ball)) [[likely]]
    return *told;
  require_figures(question, flat, ball);
  if (is_nothing(flat)) return Relation::disjoint;
  const Sign s = gap(flat, ball);
  if (s == Sign::zero && ball.radius == 0) return relate_swept(core_set(ball), 0, flat_set(flat));
  return static_cast<Relation>(-s);
}

}  // namespace

PLUMB_PAIR_ANSWER(Point3, Sphere3, relate_nearest)
PLUMB_PAIR_ANSWER(Line3, Sphere3, relate_nearest)
PLUMB_PAIR_ANSWER(Ray3, Sphere3, relate_nearest)
PLUMB_PAIR_ANSWER(Segment3, Sphere3, relate_nearest)
Relation relate_pair(PairFunction<Sphere3, Aabb3>, const Sphere3& a, const Aabb3& b, Question question) {
  return relate_nearest(b, a, question);
}

}  // namespace query
}  // namespace plumb
