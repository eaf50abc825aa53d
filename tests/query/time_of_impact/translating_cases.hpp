// Shapes in straight motion: at most a few units in size, some apart, on integers or near them.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "plumb/degenerate.hpp"
#include "plumb/figure.hpp"

namespace plumb::translating_cases {

inline constexpr int steps = 64;

/// Small integers; or near them, off by an ulp at times, of one size, of all sizes.
enum class Numbers : unsigned char { integers, noisy, ulps, scaled, wide };

class Draw {
 public:
  explicit Draw(Entropy& entropy, Numbers numbers = Numbers::integers)
      : entropy_(entropy),
        most_(1 + static_cast<std::int64_t>(entropy.below(4))),
        numbers_(numbers),
        exponent_(numbers == Numbers::scaled                   ? static_cast<int>(entropy.within(900))
                  : numbers == Numbers::wide && entropy.coin() ? 500
                                                               : 60) {}

  double number() {
    const auto n = static_cast<double>(entropy_.within(most_));
    if (numbers_ == Numbers::noisy) return n + 0.25 * signed_unit_coordinate(entropy_);
    if (numbers_ == Numbers::ulps && entropy_.below(8) == 0) return std::nextafter(n, entropy_.coin() ? 9 : -9);
    if (numbers_ == Numbers::wide) return std::ldexp(n, static_cast<int>(entropy_.within(exponent_)));
    return numbers_ == Numbers::scaled ? std::ldexp(n, exponent_) : n;
  }
  Point3 point() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }
  Vector3 vector() {
    const Point3 p = point();
    return {p.x, p.y, p.z};
  }
  Vector3 motion() {
    const double far = entropy_.coin() ? steps : 2 * steps;
    const Vector3 v = vector();
    return {far * v.x, far * v.y, far * v.z};
  }
  /// Apart from the others more often than not.
  Point3 start() {
    const Point3 p = point(), q = point();
    const double apart = static_cast<double>(entropy_.below(4));
    return {p.x + apart * q.x, p.y + apart * q.y, p.z + apart * q.z};
  }

  void fill(Point3& s) { s = start(); }
  void fill(Segment3& s) { s = {start(), start()}; }
  void fill(Triangle3& s) { s = {start(), point(), point()}; }
  void fill(Aabb3& s) {
    const Point3 p = start(), q = point();
    s = {p, {p.x + std::fabs(q.x), p.y + std::fabs(q.y), p.z + std::fabs(q.z)}};
    if (entropy_.below(20) == 0) std::swap(s.min, s.max);
  }
  void fill(Obb3& s) { s = {start(), {vector(), vector(), vector()}, {1, number(), 1}}; }
  void fill(ConvexPolyhedron3& s) {
    for (;;) {
      std::vector<Point3> points(4 + entropy_.below(4));
      const Point3 at = start();
      for (Point3& p : points) {
        p = point();
        p = {p.x + at.x, p.y + at.y, p.z + at.z};
      }
      const Hull3 hull = convex_hull(points);
      if (hull.dimension < 3) continue;
      s = convex_polyhedron(hull, points);
      return;
    }
  }
  void fill(Sphere3& s) { s = {start(), std::fabs(number())}; }
  void fill(Capsule3& s) { s = {start(), point(), std::fabs(number())}; }
  void fill(Tetrahedron3& s) { s = {start(), point(), point(), point()}; }
  void fill(Rectangle3& s) { s = {start(), {vector(), vector()}, {1, std::fabs(number())}}; }
  void fill(Lozenge3& s) { s = {start(), {vector(), vector()}, std::fabs(number())}; }
  void fill(Plane3& s) { s = {vector(), 4 * number()}; }

 private:
  Entropy& entropy_;
  std::int64_t most_;
  Numbers numbers_;
  int exponent_;
};

inline Point3 moved(const Point3& p, const Vector3& v) { return {p.x + v.x, p.y + v.y, p.z + v.z}; }
inline Segment3 moved(const Segment3& s, const Vector3& v) { return {moved(s.a, v), moved(s.b, v)}; }
inline Triangle3 moved(const Triangle3& t, const Vector3& v) { return {moved(t.a, v), moved(t.b, v), moved(t.c, v)}; }
inline Aabb3 moved(const Aabb3& b, const Vector3& v) { return {moved(b.min, v), moved(b.max, v)}; }
inline Obb3 moved(const Obb3& b, const Vector3& v) { return {moved(b.center, v), b.axes, b.half}; }
inline ConvexPolyhedron3 moved(ConvexPolyhedron3 p, const Vector3& v) {
  for (Point3& x : p.mesh.vertices) x = moved(x, v);
  return p;
}
inline Sphere3 moved(const Sphere3& s, const Vector3& v) { return {moved(s.center, v), s.radius}; }
inline Capsule3 moved(const Capsule3& c, const Vector3& v) { return {moved(c.a, v), moved(c.b, v), c.radius}; }
inline Plane3 moved(const Plane3& p, const Vector3& v) {
  return {p.normal, p.offset + (p.normal.x * v.x + p.normal.y * v.y + p.normal.z * v.z)};
}

/// A power of two times as large.
inline Point3 scaled(const Point3& p, double f) { return {f * p.x, f * p.y, f * p.z}; }
inline Vector3 scaled(const Vector3& v, double f) { return {f * v.x, f * v.y, f * v.z}; }
inline Segment3 scaled(const Segment3& s, double f) { return {scaled(s.a, f), scaled(s.b, f)}; }
inline Triangle3 scaled(const Triangle3& t, double f) { return {scaled(t.a, f), scaled(t.b, f), scaled(t.c, f)}; }
inline Aabb3 scaled(const Aabb3& b, double f) { return {scaled(b.min, f), scaled(b.max, f)}; }
inline Obb3 scaled(const Obb3& b, double f) { return {scaled(b.center, f), b.axes, scaled(b.half, f)}; }
inline ConvexPolyhedron3 scaled(ConvexPolyhedron3 p, double f) {
  for (Point3& x : p.mesh.vertices) x = scaled(x, f);
  return p;
}
inline Sphere3 scaled(const Sphere3& s, double f) { return {scaled(s.center, f), f * s.radius}; }
inline Capsule3 scaled(const Capsule3& c, double f) { return {scaled(c.a, f), scaled(c.b, f), f * c.radius}; }
inline Plane3 scaled(const Plane3& p, double f) { return {p.normal, f * p.offset}; }

/// The same set, its vertices in another order.
template <class S>
S renamed(const S& s) {
  return s;
}
inline Segment3 renamed(const Segment3& s) { return {s.b, s.a}; }
inline Triangle3 renamed(const Triangle3& t) { return {t.b, t.c, t.a}; }
inline Capsule3 renamed(const Capsule3& c) { return {c.b, c.a, c.radius}; }

}  // namespace plumb::translating_cases
