#include <algorithm>
#include <array>
#include <cmath>

#include "bench/rivals/translating_rival.hpp"

namespace plumb::bench {
namespace {

struct V {
  double x, y, z;
  friend V operator+(V a, V b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend V operator-(V a, V b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend V operator*(V a, double t) { return {a.x * t, a.y * t, a.z * t}; }
};
double dot(V a, V b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
V cross(V a, V b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
template <class P>
V of(const P& p) {
  return {p.x, p.y, p.z};
}

/// The first root of a t^2 + 2 b t + c in [0, 1].
double first_root(double a, double b, double c) {
  if (c < 0) return 0;
  if (b >= 0) return -1;
  const double rest = b * b - a * c;
  if (rest < 0) return -1;
  const double t = (-b - std::sqrt(rest)) / a;
  return t <= 1 ? t : -1;
}

double point_against_ball(V m, V v, double r) { return first_root(dot(v, v), dot(m, v), dot(m, m) - r * r); }

double first_of(double a, double b) { return a < 0 ? b : b < 0 ? a : std::min(a, b); }

double point_against_capsule(V p, V v, V a, V b, double r) {
  const V d = b - a, m = p - a;
  const double dd = dot(d, d), md = dot(m, d), vd = dot(v, d);
  const double t = first_root(dd * dot(v, v) - vd * vd, dd * dot(m, v) - vd * md, dd * (dot(m, m) - r * r) - md * md);
  if (t >= 0) {
    const double along = md + t * vd;
    if (along >= 0 && along <= dd) return t;
  }
  return first_of(point_against_ball(m, v, r), point_against_ball(p - b, v, r));
}

}  // namespace

double plain_sphere_plane(const Sphere3& s, const Vector3& by, const Plane3& p) {
  const V n = of(p.normal), v = of(by);
  const double length = std::sqrt(dot(n, n)), distance = (dot(n, of(s.center)) - p.offset) / length;
  if (std::fabs(distance) <= s.radius) return 0;
  const double speed = dot(n, v) / length;
  if (speed * distance >= 0) return -1;
  const double t = ((distance > 0 ? s.radius : -s.radius) - distance) / speed;
  return t <= 1 ? t : -1;
}

double plain_sphere_sphere(const Sphere3& a, const Vector3& v, const Sphere3& b) {
  return point_against_ball(of(a.center) - of(b.center), of(v), a.radius + b.radius);
}

double plain_sphere_triangle(const Sphere3& s, const Vector3& by, const Triangle3& triangle) {
  const V a = of(triangle.a), b = of(triangle.b), c = of(triangle.c), p = of(s.center), v = of(by);
  const V n = cross(b - a, c - a);
  const double length = std::sqrt(dot(n, n)), distance = dot(p - a, n) / length, speed = dot(v, n) / length;
  double t = 0;
  if (std::fabs(distance) > s.radius) {
    if (speed * distance >= 0) return -1;
    t = ((distance > 0 ? s.radius : -s.radius) - distance) / speed;
    if (t > 1) return -1;
  }
  const V q = p + v * t;
  if (dot(cross(b - a, q - a), n) >= 0 && dot(cross(c - b, q - b), n) >= 0 && dot(cross(a - c, q - c), n) >= 0)
    return t;
  return first_of(point_against_capsule(p, v, a, b, s.radius),
                  first_of(point_against_capsule(p, v, b, c, s.radius), point_against_capsule(p, v, c, a, s.radius)));
}

double plain_box_box(const Aabb3& a, const Vector3& v, const Aabb3& b) {
  double first = 0, last = 1;
  const auto axis = [&](double low_a, double high_a, double low_b, double high_b, double speed) {
    if (speed == 0) return high_a >= low_b && high_b >= low_a;
    double enter = (low_b - high_a) / speed, leave = (high_b - low_a) / speed;
    if (speed < 0) std::swap(enter, leave);
    first = std::max(first, enter), last = std::min(last, leave);
    return first <= last;
  };
  return axis(a.min.x, a.max.x, b.min.x, b.max.x, v.x) && axis(a.min.y, a.max.y, b.min.y, b.max.y, v.y) &&
                 axis(a.min.z, a.max.z, b.min.z, b.max.z, v.z)
             ? first
             : -1;
}

double plain_oriented(const Obb3& a, const Vector3& by, const Obb3& b) {
  const V from = of(b.center) - of(a.center), v = of(by);
  const std::array<double, 3> half_a{a.half.x, a.half.y, a.half.z}, half_b{b.half.x, b.half.y, b.half.z};
  double first = 0, last = 1;
  const auto axis = [&](V n) {
    if (dot(n, n) < 1e-12) return true;
    double reach = 0;
    for (std::size_t i = 0; i < 3; ++i)
      reach += std::fabs(half_a[i] * dot(of(a.axes[i]), n)) + std::fabs(half_b[i] * dot(of(b.axes[i]), n));
    const double gap = dot(from, n), speed = dot(v, n);
    if (speed == 0) return std::fabs(gap) <= reach;
    double enter = (gap - reach) / speed, leave = (gap + reach) / speed;
    if (speed < 0) std::swap(enter, leave);
    first = std::max(first, enter), last = std::min(last, leave);
    return first <= last;
  };
  for (const Vector3& u : a.axes) {
    if (!axis(of(u))) return -1;
  }
  for (const Vector3& u : b.axes) {
    if (!axis(of(u))) return -1;
  }
  for (const Vector3& u : a.axes) {
    for (const Vector3& w : b.axes) {
      if (!axis(cross(of(u), of(w)))) return -1;
    }
  }
  return first;
}

}  // namespace plumb::bench
