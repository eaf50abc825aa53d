// Closest points in plain doubles, as they are commonly written.
#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/rivals/closest_pairs_rival.hpp"

namespace plumb::bench {
namespace {

struct V {
  double x, y, z;
};
V operator-(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(const V& a, const V& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
V cross(const V& a, const V& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
Point3 moved(const Point3& p, const V& d, double t) { return {p.x + t * d.x, p.y + t * d.y, p.z + t * d.z}; }

struct V2 {
  double x, y;
};
V2 operator-(const Point2& a, const Point2& b) { return {a.x - b.x, a.y - b.y}; }
double dot(const V2& a, const V2& b) { return a.x * b.x + a.y * b.y; }
Point2 moved(const Point2& p, const V2& d, double t) { return {p.x + t * d.x, p.y + t * d.y}; }

constexpr double epsilon = 1e-12;

double clamped(double x) { return x < 0 ? 0 : x > 1 ? 1 : x; }

template <class Result, class Segment>
Result of_segments(const Segment& p, const Segment& q) {
  const auto d1 = p.b - p.a, d2 = q.b - q.a, r = p.a - q.a;
  const double a = dot(d1, d1), e = dot(d2, d2), f = dot(d2, r);
  double s = 0, t = 0;
  if (a <= epsilon && e <= epsilon) {
    return {p.a, q.a, dot(r, r)};
  }
  if (a <= epsilon) {
    t = clamped(f / e);
  } else {
    const double c = dot(d1, r);
    if (e <= epsilon) {
      s = clamped(-c / a);
    } else {
      const double b = dot(d1, d2), denominator = a * e - b * b;
      s = denominator > epsilon * a * e ? clamped((b * f - c * e) / denominator) : 0;
      t = (b * s + f) / e;
      if (t < 0) {
        t = 0;
        s = clamped(-c / a);
      } else if (t > 1) {
        t = 1;
        s = clamped((b - c) / a);
      }
    }
  }
  const auto x = moved(p.a, d1, s), y = moved(q.a, d2, t);
  const auto w = x - y;
  return {x, y, dot(w, w)};
}

/// The foot of p on the plane of t, if it is within.
bool foot(const Point3& p, const Triangle3& t, Point3& at) {
  const V u = t.b - t.a, v = t.c - t.a, w = p - t.a, n = cross(u, v);
  const double whole = dot(n, n);
  if (whole <= epsilon) return false;
  const double g = dot(cross(u, w), n) / whole, b = dot(cross(w, v), n) / whole;
  if (g < 0 || b < 0 || g + b > 1) return false;
  at = moved(moved(t.a, u, b), v, g);
  return true;
}

bool crossing(const Segment3& s, const Triangle3& t, Point3& at) {
  const V u = t.b - t.a, v = t.c - t.a, n = cross(u, v), d = s.b - s.a;
  const double from = dot(n, s.a - t.a), rise = dot(n, d);
  if (std::fabs(rise) <= epsilon) return false;
  const double parameter = -from / rise;
  if (parameter < 0 || parameter > 1) return false;
  const Point3 x = moved(s.a, d, parameter);
  Point3 within{};
  if (!foot(x, t, within)) return false;
  at = x;
  return true;
}

void keep(PlainClosest& best, const Point3& a, const Point3& b) {
  const V w = a - b;
  const double square = dot(w, w);
  if (square < best.square) best = {a, b, square};
}

}  // namespace

PlainClosest segments_in_doubles(const Segment3& p, const Segment3& q) { return of_segments<PlainClosest>(p, q); }
PlainClosest2 segments_in_doubles(const Segment2& p, const Segment2& q) { return of_segments<PlainClosest2>(p, q); }

PlainClosest lines_in_doubles(const Line3& p, const Line3& q) {
  const V d1{p.direction.x, p.direction.y, p.direction.z}, d2{q.direction.x, q.direction.y, q.direction.z};
  const V r = p.point - q.point;
  const double a = dot(d1, d1), e = dot(d2, d2), b = dot(d1, d2), c = dot(d1, r), f = dot(d2, r);
  const double denominator = a * e - b * b;
  const double s = denominator > epsilon * a * e ? (b * f - c * e) / denominator : 0;
  const double t = (b * s + f) / e;
  const Point3 x = moved(p.point, d1, s), y = moved(q.point, d2, t);
  const V w = x - y;
  return {x, y, dot(w, w)};
}

PlainClosest segment_triangle_in_doubles(const Segment3& s, const Triangle3& t) {
  Point3 at{};
  if (crossing(s, t, at)) return {at, at, 0};
  PlainClosest best{{}, {}, std::numeric_limits<double>::infinity()};
  for (const Segment3& edge : {Segment3{t.a, t.b}, Segment3{t.b, t.c}, Segment3{t.c, t.a}}) {
    const PlainClosest c = segments_in_doubles(s, edge);
    if (c.square < best.square) best = c;
  }
  for (const Point3& p : {s.a, s.b}) {
    if (foot(p, t, at)) keep(best, p, at);
  }
  return best;
}

PlainClosest triangles_in_doubles(const Triangle3& p, const Triangle3& q) {
  const Point3 a[3] = {p.a, p.b, p.c}, b[3] = {q.a, q.b, q.c};
  PlainClosest best{{}, {}, std::numeric_limits<double>::infinity()};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const PlainClosest c = segments_in_doubles(Segment3{a[i], a[(i + 1) % 3]}, Segment3{b[j], b[(j + 1) % 3]});
      if (!(c.square < best.square)) continue;
      best = c;
      const V w = c.on_b - c.on_a;
      if (dot(a[(i + 2) % 3] - c.on_a, w) <= 0 && dot(b[(j + 2) % 3] - c.on_b, w) >= 0) return best;
    }
  }
  Point3 at{};
  for (int i = 0; i < 3; ++i) {
    if (crossing({a[i], a[(i + 1) % 3]}, q, at) || crossing({b[i], b[(i + 1) % 3]}, p, at)) return {at, at, 0};
  }
  for (int i = 0; i < 3; ++i) {
    if (foot(a[i], q, at)) keep(best, a[i], at);
    if (foot(b[i], p, at)) {
      const V w = at - b[i];
      if (dot(w, w) < best.square) best = {at, b[i], dot(w, w)};
    }
  }
  return best;
}

}  // namespace plumb::bench
