#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bench/rivals/ray_rival.hpp"

namespace plumb::bench {
namespace {

struct Vec {
  double x, y, z;
};
template <class P, class Q>
Vec minus(const P& a, const Q& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class U, class V>
double dot(const U& u, const V& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}
template <class U, class V>
Vec cross(const U& u, const V& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

constexpr double epsilon = 1e-12;

template <class Direction>
std::optional<double> moller_trumbore(const Point3& o, const Direction& d, const Triangle3& t, double most) {
  const Vec e = minus(t.b, t.a), f = minus(t.c, t.a);
  const Vec p = cross(d, f);
  const double det = dot(e, p);
  if (det > -epsilon && det < epsilon) return {};
  const double inverse = 1 / det;
  const Vec s = minus(o, t.a);
  const double u = dot(s, p) * inverse;
  if (u < 0 || u > 1) return {};
  const Vec q = cross(s, e);
  const double v = dot(d, q) * inverse;
  if (v < 0 || u + v > 1) return {};
  const double at = dot(f, q) * inverse;
  if (at < 0 || at > most) return {};
  return at;
}

constexpr double infinity = std::numeric_limits<double>::infinity();

bool slab(double o, double d, double min, double max, double& from, double& to) {
  if (std::fabs(d) < epsilon) return o >= min && o <= max;
  const double inverse = 1 / d;
  double near = (min - o) * inverse, far = (max - o) * inverse;
  if (near > far) std::swap(near, far);
  from = std::max(from, near);
  to = std::min(to, far);
  return from <= to;
}

}  // namespace

std::optional<double> plain_hit(const Ray3& ray, const Triangle3& t) {
  return moller_trumbore(ray.origin, ray.direction, t, infinity);
}
std::optional<double> plain_hit(const Segment3& s, const Triangle3& t) {
  return moller_trumbore(s.a, minus(s.b, s.a), t, 1);
}

std::optional<double> plain_hit(const Ray3& ray, const Sphere3& s) {
  const Vec m = minus(ray.origin, s.center);
  const double b = dot(m, ray.direction), c = dot(m, m) - s.radius * s.radius;
  if (c > 0 && b > 0) return {};
  const double a = dot(ray.direction, ray.direction), discriminant = b * b - a * c;
  if (discriminant < 0) return {};
  const double t = (-b - std::sqrt(discriminant)) / a;
  return t < 0 ? 0 : t;
}

std::optional<double> plain_hit(const Ray3& ray, const Aabb3& b) {
  double from = 0, to = infinity;
  const auto& [o, d] = ray;
  if (!slab(o.x, d.x, b.min.x, b.max.x, from, to) || !slab(o.y, d.y, b.min.y, b.max.y, from, to) ||
      !slab(o.z, d.z, b.min.z, b.max.z, from, to))
    return {};
  return from;
}

bool plain_hits(const Ray3& ray, const Triangle3& t) { return plain_hit(ray, t).has_value(); }
bool plain_hits(const Segment3& s, const Triangle3& t) { return plain_hit(s, t).has_value(); }
bool plain_hits(const Ray3& ray, const Aabb3& b) { return plain_hit(ray, b).has_value(); }

bool plain_hits(const Ray3& ray, const Sphere3& s) {
  const Vec m = minus(ray.origin, s.center);
  const double c = dot(m, m) - s.radius * s.radius;
  if (c <= 0) return true;
  const double b = dot(m, ray.direction);
  if (b > 0) return false;
  return b * b - dot(ray.direction, ray.direction) * c >= 0;
}

std::optional<std::uint32_t> plain_first_hit(const Ray3& ray, std::span<const Triangle3> triangles) {
  double least = infinity;
  std::optional<std::uint32_t> best;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto t = plain_hit(ray, triangles[i]);
    if (t && *t < least) least = *t, best = static_cast<std::uint32_t>(i);
  }
  return best;
}

}  // namespace plumb::bench
