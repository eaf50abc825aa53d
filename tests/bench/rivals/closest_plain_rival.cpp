// Nearest points in plain doubles: the parameter clamped, the region of a triangle by six dot products, boxes clamped.
#include <algorithm>
#include <cmath>

#include "bench/rivals/closest_rival.hpp"

namespace plumb::bench {
namespace {

double dot(const Vector3& u, const Vector3& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }
Vector3 minus(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Point3 along(const Point3& a, const Vector3& d, double t) { return {a.x + t * d.x, a.y + t * d.y, a.z + t * d.z}; }
NearestFound found(const Point3& q, const Point3& p) {
  const Vector3 way = minus(p, q);
  return {q, std::sqrt(dot(way, way))};
}

Point3 nearest_of_triangle(const Triangle3& t, const Point3& p) {
  const Vector3 ab = minus(t.b, t.a), ac = minus(t.c, t.a), ap = minus(p, t.a);
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return t.a;
  const Vector3 bp = minus(p, t.b);
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return t.b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return along(t.a, ab, d1 / (d1 - d3));
  const Vector3 cp = minus(p, t.c);
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return t.c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return along(t.a, ac, d2 / (d2 - d6));
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return along(t.b, minus(t.c, t.b), (d4 - d3) / ((d4 - d3) + (d5 - d6)));
  const double scale = 1 / (va + vb + vc);
  return along(along(t.a, ab, vb * scale), ac, vc * scale);
}

}  // namespace

NearestFound nearest_in_doubles(const Segment3& s, const Point3& p) {
  const Vector3 ab = minus(s.b, s.a);
  double t = dot(minus(p, s.a), ab);
  if (t <= 0) return found(s.a, p);
  const double whole = dot(ab, ab);
  if (t >= whole) return found(s.b, p);
  t /= whole;
  return found(along(s.a, ab, t), p);
}

NearestFound nearest_in_doubles(const Triangle3& t, const Point3& p) { return found(nearest_of_triangle(t, p), p); }

NearestFound nearest_in_doubles(const Aabb3& box, const Point3& p) {
  return found({std::clamp(p.x, box.min.x, box.max.x), std::clamp(p.y, box.min.y, box.max.y),
                std::clamp(p.z, box.min.z, box.max.z)},
               p);
}

NearestFound nearest_in_doubles(const Obb3& box, const Point3& p) {
  const Vector3 d = minus(p, box.center);
  Point3 q = box.center;
  const double half[3] = {box.half.x, box.half.y, box.half.z};
  for (std::size_t i = 0; i < 3; ++i) q = along(q, box.axes[i], std::clamp(dot(d, box.axes[i]), -half[i], half[i]));
  return found(q, p);
}

}  // namespace plumb::bench
