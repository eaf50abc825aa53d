#include <algorithm>
#include <cmath>

#include "core_distance.hpp"
#include "finite_parts.hpp"
#include "lozenge_gap.hpp"
#include "plumb/figure/swept_sphere.hpp"
#include "rational_lp.hpp"
#include "swept_input.hpp"

namespace plumb {
namespace {

using swept::check;

// The distance of the cores against the sum of the radii, over numbers of type T; nothing where they do not tell.
template <class T, class Shape>
Unsure<Sign> sign_of_gap(const Shape& a, const Shape& b) {
  core::Question ask;
  const T reach = T(a.radius) + T(b.radius), square = reach * reach;
  Sign least = Sign::positive;
  core::visit_distances(core::core_of<T>(a), core::core_of<T>(b), ask, [&](const T& numerator, const T& denominator) {
    least = std::min(least, ask(numerator - square * denominator));
  });
  return ask.certain() ? Unsure(least) : Unsure<Sign>();
}

// Do the relative interiors of two cores meet?  They are the images of open intervals and squares.
template <class Shape>
bool interiors_meet(const Shape& a, const Shape& b) {
  const auto directions = [](const Shape& s) {
    if constexpr (std::is_same_v<Shape, Capsule3>) {
      const auto of = [](const Point3& p) { return figure::RationalVector{p.x, p.y, p.z}; };
      figure::RationalVector from = of(s.a), along = of(s.b);
      for (std::size_t i = 0; i < 3; ++i) along[i] -= from[i];
      return std::vector{from, along};
    } else {
      const auto of = [](const auto& p) { return figure::RationalVector{p.x, p.y, p.z}; };
      return std::vector{of(s.corner), of(s.edges[0]), of(s.edges[1])};
    }
  };
  const auto of_a = directions(a), of_b = directions(b);
  const std::size_t n = of_a.size() - 1, variables = 2 * n;
  figure::Constraints all;
  std::vector<bool> strictly;
  const auto add = [&](figure::RationalVector row, mpq_class limit, bool strict) {
    all.add(std::move(row), std::move(limit));
    strictly.push_back(strict);
  };
  for (std::size_t v = 0; v < variables; ++v) {
    figure::RationalVector row(variables);
    row[v] = 1;
    add(row, 1, true);
    row[v] = -1;
    add(row, 0, true);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    figure::RationalVector row(variables);
    for (std::size_t v = 0; v < n; ++v) row[v] = of_a[v + 1][axis], row[n + v] = -of_b[v + 1][axis];
    const mpq_class apart = of_b[0][axis] - of_a[0][axis];
    add(row, apart, false);
    for (mpq_class& x : row) x = -x;
    add(std::move(row), -apart, false);
  }
  return figure::feasible(all, strictly).slack > 0;
}

template <class Shape>
Relation relation(std::string_view function, const Shape& a, const Shape& b) {
  check(function, "a", a);
  check(function, "b", b);
  Unsure<Sign> gap = sign_of_gap<Interval>(a, b);
  if (!gap.certain()) gap = sign_of_gap<BigDyadic>(a, b);
  if (gap.value() != Sign::zero) return static_cast<Relation>(-gap.value());
  return a.radius == 0 && b.radius == 0 && interiors_meet(a, b) ? Relation::overlapping : Relation::touching;
}

// (p, q, x, y, f): the points p + f (q - p) on one segment and x + g (y - x) on the other, against the sum of radii.
struct NearPoints {
  static constexpr std::string_view name = "relate";
  static constexpr std::array arguments{3, 3, 1, 3, 3, 1, 1, 1};
  static constexpr bool homogeneous = false;
  template <class T>
  constexpr auto operator()(const std::array<T, 16>& p) const {
    const auto difference = [&](std::size_t i) {
      return (p[i] - p[7 + i]) + (p[6] * (p[3 + i] - p[i]) - p[13] * (p[10 + i] - p[7 + i]));
    };
    const auto x = difference(0), y = difference(1), z = difference(2);
    const auto reach = p[14] + p[15];
    return x * x + y * y + z * z - reach * reach;
  }
};

// (x, y, n, r, s): n . (x - y) - r - s.
struct PlaneBetween {
  static constexpr std::string_view name = "relate";
  static constexpr std::array arguments{3, 3, 3, 1, 1};
  static constexpr bool homogeneous = false;
  template <class T>
  constexpr auto operator()(const std::array<T, 11>& p) const {
    return ((p[0] - p[3]) * p[6] + (p[1] - p[4]) * p[7] + (p[2] - p[5]) * p[8]) - (p[9] + p[10]);
  }
};

// (n, l): l^2 - n^2.
struct Shorter {
  static constexpr std::string_view name = "relate";
  static constexpr std::array arguments{3, 1};
  template <class T>
  constexpr auto operator()(const std::array<T, 4>& p) const {
    return p[3] * p[3] - (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
  }
};

double clamped(double x) { return x < 0 ? 0 : x > 1 ? 1 : x; }

// Two nearly nearest points in plain doubles, and what they prove: nearer than the radii reach, or a plane between.
std::optional<Sign> quick_gap(const Capsule3& a, const Capsule3& b) {
  if (!(a.radius >= 0 && b.radius >= 0)) return {};
  const Vector3 u{a.b.x - a.a.x, a.b.y - a.a.y, a.b.z - a.a.z}, v{b.b.x - b.a.x, b.b.y - b.a.y, b.b.z - b.a.z};
  const Vector3 w{a.a.x - b.a.x, a.a.y - b.a.y, a.a.z - b.a.z};
  const auto dot = [](const Vector3& p, const Vector3& q) { return p.x * q.x + p.y * q.y + p.z * q.z; };
  const double uu = dot(u, u), vv = dot(v, v), uv = dot(u, v), uw = dot(u, w), vw = dot(v, w);
  const double area = uu * vv - uv * uv;
  double s = area > 0 ? clamped((uv * vw - uw * vv) / area) : 0;
  double t = vv > 0 ? clamped((uv * s + vw) / vv) : 0;
  s = uu > 0 ? clamped((uv * t - uw) / uu) : 0;
  assert_sound_thread();
  if (filter<NearPoints>({a.a.x, a.a.y, a.a.z, a.b.x, a.b.y, a.b.z, s, b.a.x, b.a.y, b.a.z, b.b.x, b.b.y, b.b.z, t,
                          a.radius, b.radius}) < 0)
    return Sign::negative;
  Vector3 n{w.x + (s * u.x - t * v.x), w.y + (s * u.y - t * v.y), w.z + (s * u.z - t * v.z)};
  const double shrink = (1 - 0x1p-50) / std::sqrt(dot(n, n));
  n = {n.x * shrink, n.y * shrink, n.z * shrink};
  if (filter<Shorter>({n.x, n.y, n.z, 1.0}) <= 0) return {};
  for (const Point3& x : {a.a, a.b}) {
    for (const Point3& y : {b.a, b.b}) {
      if (filter<PlaneBetween>({x.x, x.y, x.z, y.x, y.y, y.z, n.x, n.y, n.z, a.radius, b.radius}) <= 0) return {};
    }
  }
  return Sign::positive;
}

using swept::quick_gap;

template <class Shape>
Relation quick_relation(std::string_view function, const Shape& a, const Shape& b) {
  if (const auto gap = quick_gap(a, b)) [[likely]]
    return static_cast<Relation>(-*gap);
  return relation(function, a, b);
}

Capsule3 in_space(const Capsule2& c) { return {{c.a.x, c.a.y, 0}, {c.b.x, c.b.y, 0}, c.radius}; }

}  // namespace

Relation relate(const Capsule2& a, const Capsule2& b) { return relate(in_space(a), in_space(b)); }
Relation relate(const Capsule3& a, const Capsule3& b) { return quick_relation("relate", a, b); }
Relation relate(const Lozenge3& a, const Lozenge3& b) { return quick_relation("relate", a, b); }
bool intersects(const Capsule2& a, const Capsule2& b) { return intersects(in_space(a), in_space(b)); }
bool intersects(const Capsule3& a, const Capsule3& b) {
  return quick_relation("intersects", a, b) != Relation::disjoint;
}
bool intersects(const Lozenge3& a, const Lozenge3& b) {
  return quick_relation("intersects", a, b) != Relation::disjoint;
}

}  // namespace plumb
