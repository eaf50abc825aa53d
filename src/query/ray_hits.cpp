#include "plumb/query/ray_hits.hpp"

#include <plumb/predicates/distance.hpp>

#include "plumb/figure/contains.hpp"
#include "plumb/predicates.hpp"
#include "query/ray_exact_hits.hpp"
#include "query/ray_filters.hpp"
#include "query/ray_numbers.hpp"
#include "query/ray_shot.hpp"

namespace plumb {
namespace query {
namespace {

using predicates::Triple;
using Numbers = Triple<double>;

/// What a filter says.
enum class Told : signed char { no = 0, yes = 1, nothing = 2 };

template <class P, class Q>
Numbers difference(const P& from, const Q& to) {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}
double largest(double a, double b, double c) {
  const double x = magnitude_of(a), y = magnitude_of(b), z = magnitude_of(c);
  const double m = x > y ? x : y;
  return m > z ? m : z;
}

/// NaN where x is infinite or NaN: nothing is beyond it then.
double unless_overflown(double x) { return x - x; }

/// Of the line from o along d, which begins and ends as said.
template <bool begins, bool ends>
Told ask_triangle(const Point3& o, const Numbers& d, const Triangle3& triangle) {
  const Numbers a = difference(o, triangle.a), b = difference(o, triangle.b), c = difference(o, triangle.c);
  const Numbers of_ab = cross(b, a), of_bc = cross(c, b), of_ca = cross(a, c);
  const double ab = dot(d, of_ab), bc = dot(d, of_bc), ca = dot(d, of_ca);
  const double x = largest(a.x, b.x, c.x), y = largest(a.y, b.y, c.y), z = largest(a.z, b.z, c.z);
  const double yz = y * z + guard_inside, zx = z * x + guard_inside, xy = x * y + guard_inside;
  const double magnitude = magnitude_of(d.x) * yz + magnitude_of(d.y) * zx + magnitude_of(d.z) * xy;
  const double sum = ab + bc + ca;
  const double doubt = edge_constant * (magnitude_slack * magnitude + guard) + unless_overflown(sum);
  const bool left = (ab > doubt) | (bc > doubt) | (ca > doubt), right = (ab < -doubt) | (bc < -doubt) | (ca < -doubt);
  if (left & right) return Told::no;
  const bool all_left = (ab > doubt) & (bc > doubt) & (ca > doubt);
  const bool all_right = (ab < -doubt) & (bc < -doubt) & (ca < -doubt);
  if (!(all_left | all_right)) return Told::nothing;
  if constexpr (begins) {
    // N = -value, D has the sign of -sum: t has the sign of value * sum.
    const double value = dot(a, of_bc), way = all_left ? value : -value;
    const double off = filter_constant<PlaneAhead>() * (magnitude_slack * (x * yz + y * zx + z * xy) + guard) +
                       unless_overflown(value);
    if (way < -off) return Told::no;
    if (!(way > off)) return Told::nothing;
    if constexpr (ends) {
      // (N - D) / D = t - 1, and N - D = sum - value.
      const double rest = sum - value, beyond = all_left ? -rest : rest;
      const double doubt_of_end =
          filter_constant<PlaneBehindEnd>() * (magnitude_slack * (3 * magnitude + (x * yz + y * zx + z * xy)) + guard) +
          unless_overflown(rest);
      if (beyond > doubt_of_end) return Told::no;
      if (!(beyond < -doubt_of_end)) return Told::nothing;
    }
  }
  return Told::yes;
}

/// (center, radius, p): is p beyond the ball?
struct BeyondBall {
  static constexpr std::string_view name = "hits";
  static constexpr std::array arguments{3, 1, 3};
  template <class T>
  constexpr auto operator()(const std::array<T, 7>& p) const {
    const Triple w{p[4] - p[0], p[5] - p[1], p[6] - p[2]};
    return dot(w, w) - p[3] * p[3];
  }
};
/// (p, q, c): does the way from p to q lead away from c?
struct LeadsAway {
  static constexpr std::string_view name = "hits";
  static constexpr int points = 3, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 9>& p) const {
    return dot(predicates::difference(p, 2, 0), predicates::difference(p, 0, 1));
  }
};
/// (p, q, center, radius): the discriminant of the line from p to q and the ball.
struct MeetsBall {
  static constexpr std::string_view name = "hits";
  static constexpr std::array arguments{3, 3, 3, 1};
  template <class T>
  constexpr auto operator()(const std::array<T, 10>& p) const {
    const auto w = predicates::difference(p, 2, 0), d = predicates::difference(p, 0, 1);
    const auto b = dot(w, d);
    return b * b - dot(d, d) * (dot(w, w) - p[9] * p[9]);
  }
};

double size_of_products(const Numbers& u, const Numbers& v) {
  return magnitude_of(u.x * v.x) + magnitude_of(u.y * v.y) + magnitude_of(u.z * v.z);
}

/// The direction may be a rounded difference: the constants are those of differences, which are no less than those of
/// directions as given.
template <bool begins, bool ends>
Told ask_ball(const Point3& o, const Numbers& d, const Point3& end, const Sphere3& ball) {
  const Numbers w = difference(ball.center, o);
  const double square = dot(w, w), reach = ball.radius * ball.radius, beyond = square - reach;
  const double b = dot(w, d), length = dot(d, d);
  const double value = b * b - length * beyond;
  const double most = (length + guard) * (2 * square + reach + guard) + guard;
  const double doubt = filter_constant<MeetsBall>() * magnitude_slack * most + unless_overflown(value);
  if (!(doubt >= 0) || ball.radius < 0) return Told::nothing;  // a number is none, or too large
  if (value < -doubt) return Told::no;
  const double near = filter_constant<BeyondBall>() * magnitude_slack * (square + reach + guard);
  if (begins && beyond < -near) return Told::yes;
  if (!(value > doubt)) return Told::nothing;
  if constexpr (begins) {
    const double off = filter_constant<LeadsAway>() * magnitude_slack * (size_of_products(w, d) + guard);
    if (b > off) return beyond > near ? Told::no : Told::nothing;
    if (!(b < -off)) return Told::nothing;
    if constexpr (ends) {
      const Numbers v = difference(ball.center, end);
      const double far = dot(v, v), out = far - reach, along = dot(v, d);
      if (out < -filter_constant<BeyondBall>() * magnitude_slack * (far + reach + guard)) return Told::yes;
      const double doubt_of_end = filter_constant<LeadsAway>() * magnitude_slack * (size_of_products(v, d) + guard);
      if (along > doubt_of_end) return Told::yes;
      if (!(along < -doubt_of_end)) return Told::nothing;
      return out > filter_constant<BeyondBall>() * magnitude_slack * (far + reach + guard) ? Told::no : Told::nothing;
    }
  }
  return Told::yes;
}

/// Do all corners of a rectangle lie on one side of the line along (u, v), of the sides seen from its origin?
Told apart_in_plane(double u, double v, double low_u, double high_u, double low_v, double high_v) {
  if (u == 0 && v == 0) return Told::no;
  // The corners at which u * y - v * x is the most and the least.
  const double up = u >= 0 ? high_v : low_v, down = u >= 0 ? low_v : high_v;
  const double left = v >= 0 ? low_u : high_u, right = v >= 0 ? high_u : low_u;
  const double a = u * up, b = v * left, c = u * down, d = v * right;
  constexpr double constant = 2 * filter_constant<PassesCorner>();
  const double most = a - b, least = c - d;
  // Infinite, and so beyond all, where a product is; NaN where a number is.
  const double doubt = constant * ((magnitude_of(a) + magnitude_of(b)) + (magnitude_of(c) + magnitude_of(d)) + guard);
  if ((most < -doubt) | (least > doubt)) return Told::yes;
  return ((most > doubt) & (least < -doubt)) ? Told::no : Told::nothing;
}

/// By comparing numbers as given: does an axis of the box part it from a ray, from a segment?
bool ahead(double from, double along, double min, double max) {
  return !(((from > max) & (along >= 0)) | ((from < min) & (along <= 0)));
}
bool overlap(double a, double b, double min, double max) {
  return !(((a > max) & (b > max)) | ((a < min) & (b < min)));
}

/// Without a branch.
bool every(bool x, bool y, bool z) { return x & y & z; }

/// Of a line with some direction.  Where no axis of an edge and the direction parts them the line meets the box; a ray
/// and a segment do, where no axis of the box parts them either: where they reach it.
Told ask_box(const Point3& o, const Numbers& d, const Aabb3& box, bool reaches) {
  const Numbers low = difference(o, box.min), high = difference(o, box.max);
  // Finite only where all are numbers.
  const double all = ((low.x + low.y) + (low.z + high.x)) + ((high.y + high.z) + (d.x + d.y)) + d.z;
  const bool full = (box.min.x <= box.max.x) & (box.min.y <= box.max.y) & (box.min.z <= box.max.z);
  if (!(unless_overflown(all) == 0) || !full) return Told::nothing;
  if (!reaches) return Told::no;
  const Told x = apart_in_plane(d.y, d.z, low.y, high.y, low.z, high.z);
  if (x == Told::yes) return Told::no;
  const Told y = apart_in_plane(d.z, d.x, low.z, high.z, low.x, high.x);
  if (y == Told::yes) return Told::no;
  const Told z = apart_in_plane(d.x, d.y, low.x, high.x, low.y, high.y);
  if (z == Told::yes) return Told::no;
  return ((x == Told::no) & (y == Told::no) & (z == Told::no)) ? Told::yes : Told::nothing;
}

template <class Ask, class Exactly>
bool told_or(Ask told, const Exactly& exactly) {
  if (told != Told::nothing) [[likely]]
    return told == Told::yes;
  return exactly();
}

Numbers numbers(const Vector3& v) { return {v.x, v.y, v.z}; }

[[gnu::noinline]] bool exactly(const AnyRay& ray, const Triangle3& t, HitRule rule) {
  require_ray("hits", ray, t);
  return is_hit(ray, t, rule);
}
[[gnu::noinline]] bool exactly(const AnyRay& ray, const Sphere3& s) {
  require_ray("hits", ray, s);
  return is_hit(ray, s);
}
/// (origin, direction, corner) in a plane of two axes: PassesCorner for a direction as given.
struct RayPassesCorner {
  static constexpr std::string_view name = "hits";
  static constexpr int points = 3, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 6>& p) const {
    return p[2] * (p[5] - p[1]) - p[3] * (p[4] - p[0]);
  }
};

/// By exact signs: are all corners of the box, in the plane of two axes, strictly on one side?
bool parted_in_plane(const AnyRay& ray, const Aabb3& box, std::size_t j, std::size_t k) {
  const auto o = coordinates(ray.origin), min = coordinates(box.min), max = coordinates(box.max);
  const auto to = ends(ray) ? coordinates(ray.end) : coordinates(ray.direction);
  const bool segment = ends(ray), right = segment ? to[j] >= o[j] : to[j] >= 0,
             up = segment ? to[k] >= o[k] : to[k] >= 0;
  const auto side = [&](double x, double y) {
    if (segment) return orient2d({o[j], o[k]}, {to[j], to[k]}, {x, y});
    return sign_of(RayPassesCorner{}, Point2{o[j], o[k]}, Vector2{to[j], to[k]}, Point2{x, y});
  };
  return side(up ? min[j] : max[j], right ? max[k] : min[k]) == Sign::negative ||
         side(up ? max[j] : min[j], right ? min[k] : max[k]) == Sign::positive;
}

/// The segment or ray reaches the box along every axis, or it is a line of some direction.
[[gnu::noinline]] bool exactly(const AnyRay& ray, const Aabb3& b, bool reaches) {
  require_ray("hits", ray, b);
  if (!reaches || !every(b.min.x <= b.max.x, b.min.y <= b.max.y, b.min.z <= b.max.z)) return false;
  return !parted_in_plane(ray, b, 0, 1) && !parted_in_plane(ray, b, 1, 2) && !parted_in_plane(ray, b, 2, 0);
}

}  // namespace
}  // namespace query

using namespace query;

bool hits(const Ray3& ray, const Triangle3& triangle, HitRule rule) {
  return told_or(ask_triangle<true, false>(ray.origin, numbers(ray.direction), triangle),
                 [&] { return exactly(ray, triangle, rule); });
}
bool hits(const Segment3& segment, const Triangle3& triangle, HitRule rule) {
  return told_or(ask_triangle<true, true>(segment.a, difference(segment.a, segment.b), triangle),
                 [&] { return exactly(segment, triangle, rule); });
}
bool hits(const Line3& line, const Triangle3& triangle, HitRule rule) {
  return told_or(ask_triangle<false, false>(line.point, numbers(line.direction), triangle),
                 [&] { return exactly(line, triangle, rule); });
}

bool hits(const Ray3& ray, const Sphere3& sphere) {
  return told_or(ask_ball<true, false>(ray.origin, numbers(ray.direction), ray.origin, sphere),
                 [&] { return exactly(ray, sphere); });
}
bool hits(const Segment3& segment, const Sphere3& sphere) {
  return told_or(ask_ball<true, true>(segment.a, difference(segment.a, segment.b), segment.b, sphere),
                 [&] { return exactly(segment, sphere); });
}
bool hits(const Line3& line, const Sphere3& sphere) {
  return told_or(ask_ball<false, false>(line.point, numbers(line.direction), line.point, sphere),
                 [&] { return exactly(line, sphere); });
}

bool hits(const Ray3& ray, const Aabb3& box) {
  const auto& [o, d] = ray;
  const bool reaches = every(ahead(o.x, d.x, box.min.x, box.max.x), ahead(o.y, d.y, box.min.y, box.max.y),
                             ahead(o.z, d.z, box.min.z, box.max.z));
  return told_or(ask_box(o, numbers(d), box, reaches), [&] { return exactly(ray, box, reaches); });
}
bool hits(const Segment3& segment, const Aabb3& box) {
  const auto& [a, b] = segment;
  const bool reaches = every(overlap(a.x, b.x, box.min.x, box.max.x), overlap(a.y, b.y, box.min.y, box.max.y),
                             overlap(a.z, b.z, box.min.z, box.max.z));
  return told_or(ask_box(a, difference(a, b), box, reaches), [&] { return exactly(segment, box, reaches); });
}
bool hits(const Line3& line, const Aabb3& box) {
  if (line.direction == Vector3{0, 0, 0}) {
    require_ray("hits", line, box);
    return contains(box, line.point);
  }
  return told_or(ask_box(line.point, numbers(line.direction), box, true), [&] { return exactly(line, box, true); });
}

}  // namespace plumb
