#include "bench/rivals/intersection_rival.hpp"

namespace plumb::bench {
namespace {

double area(const Point2& a, const Point2& b, const Point2& c) {
  return (a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x);
}
Vector3 from_to(const Point3& a, const Point3& b) { return {b.x - a.x, b.y - a.y, b.z - a.z}; }
Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dot(const Vector3& a, const Vector3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

}  // namespace

bool crossing_in_doubles(const Segment2& s, const Segment2& t, Point2& at) {
  const double a = area(s.a, s.b, t.b), b = area(s.a, s.b, t.a);
  if (a * b > 0) return false;
  const double c = area(t.a, t.b, s.a), d = c + b - a;
  if (c * d > 0 || c == d) return false;
  const double way = c / (c - d);
  at = {s.a.x + way * (s.b.x - s.a.x), s.a.y + way * (s.b.y - s.a.y)};
  return true;
}

bool crossing_in_doubles(const Segment3& s, const Triangle3& t, Point3& at) {
  const Vector3 u = from_to(t.a, t.b), v = from_to(t.a, t.c), way = from_to(s.b, s.a), n = cross(u, v);
  const double d = dot(way, n);
  if (d == 0) return false;
  const Vector3 from = from_to(t.a, s.a), e = cross(way, from);
  const double sign = d < 0 ? -1 : 1, whole = d * sign, part = dot(from, n) * sign;
  if (part < 0 || part > whole) return false;
  const double y = dot(v, e) * sign, z = -dot(u, e) * sign;
  if (y < 0 || z < 0 || y + z > whole) return false;
  const double k = part / whole;
  at = {s.a.x - k * way.x, s.a.y - k * way.y, s.a.z - k * way.z};
  return true;
}

}  // namespace plumb::bench
