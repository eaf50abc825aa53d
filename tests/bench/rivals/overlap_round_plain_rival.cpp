// The tests of round shapes in plain doubles, as commonly written: nearest points, and squares compared.
#include <algorithm>
#include <cmath>

#include "bench/rivals/overlap_round_rival.hpp"

namespace plumb::bench::plain {
namespace {

struct V {
  double x, y, z;
  friend V operator-(const V& a, const V& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend V operator+(const V& a, const V& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend V operator*(const V& a, double t) { return {a.x * t, a.y * t, a.z * t}; }
};
V of(const Point3& p) { return {p.x, p.y, p.z}; }
V of(const Vector3& p) { return {p.x, p.y, p.z}; }
double dot(const V& a, const V& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
V cross(const V& a, const V& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
double clamped(double x, double low, double high) { return x < low ? low : x > high ? high : x; }

double squared_distance(const V& a, const V& b, const V& p) {
  const V ab = b - a, ap = p - a, bp = p - b;
  const double e = dot(ap, ab);
  if (e <= 0) return dot(ap, ap);
  const double f = dot(ab, ab);
  if (e >= f) return dot(bp, bp);
  return dot(ap, ap) - e * e / f;
}

V nearest_of_triangle(const V& a, const V& b, const V& c, const V& p) {
  const V ab = b - a, ac = c - a, ap = p - a;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const V bp = p - b;
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + ab * (d1 / (d1 - d3));
  const V cp = p - c;
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + ac * (d2 / (d2 - d6));
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
  const double whole = 1 / (va + vb + vc);
  return a + ab * (vb * whole) + ac * (vc * whole);
}

double squared_distance_of_segments(const V& p1, const V& q1, const V& p2, const V& q2) {
  constexpr double epsilon = 1e-12;
  const V d1 = q1 - p1, d2 = q2 - p2, r = p1 - p2;
  const double a = dot(d1, d1), e = dot(d2, d2), f = dot(d2, r);
  double s = 0, t = 0;
  if (a <= epsilon && e <= epsilon) return dot(r, r);
  if (a <= epsilon) {
    t = clamped(f / e, 0, 1);
  } else {
    const double c = dot(d1, r);
    if (e <= epsilon) {
      s = clamped(-c / a, 0, 1);
    } else {
      const double b = dot(d1, d2), denominator = a * e - b * b;
      s = denominator != 0 ? clamped((b * f - c * e) / denominator, 0, 1) : 0;
      t = (b * s + f) / e;
      if (t < 0) {
        t = 0;
        s = clamped(-c / a, 0, 1);
      } else if (t > 1) {
        t = 1;
        s = clamped((b - c) / a, 0, 1);
      }
    }
  }
  const V w = (p1 + d1 * s) - (p2 + d2 * t);
  return dot(w, w);
}

bool pierces(const V& p, const V& q, const V& a, const V& b, const V& c) {
  const V ab = b - a, ac = c - a, qp = p - q, n = cross(ab, ac);
  const double d = dot(qp, n);
  if (d == 0) return false;
  const V ap = p - a;
  const double t = dot(ap, n) / d;
  if (t < 0 || t > 1) return false;
  const V e = cross(qp, ap);
  const double v = dot(ac, e) / d, w = -dot(ab, e) / d;
  return v >= 0 && w >= 0 && v + w <= 1;
}

double squared_distance(const Aabb3& box, const V& p) {
  const auto past = [](double x, double low, double high) { return x < low ? low - x : x > high ? x - high : 0; };
  const V d{past(p.x, box.min.x, box.max.x), past(p.y, box.min.y, box.max.y), past(p.z, box.min.z, box.max.z)};
  return dot(d, d);
}

bool crosses(const Aabb3& box, const V& p, const V& d) {
  double from = 0, to = 1;
  const double start[3] = {p.x, p.y, p.z}, way[3] = {d.x, d.y, d.z};
  const double low[3] = {box.min.x, box.min.y, box.min.z}, high[3] = {box.max.x, box.max.y, box.max.z};
  for (int i = 0; i < 3; ++i) {
    if (std::fabs(way[i]) < 1e-12) {
      if (start[i] < low[i] || start[i] > high[i]) return false;
      continue;
    }
    const double inverse = 1 / way[i];
    double t1 = (low[i] - start[i]) * inverse, t2 = (high[i] - start[i]) * inverse;
    if (t1 > t2) std::swap(t1, t2);
    from = std::max(from, t1);
    to = std::min(to, t2);
    if (from > to) return false;
  }
  return true;
}

}  // namespace

bool meet(const Plane3& plane, const Sphere3& ball) {
  return std::fabs(dot(of(plane.normal), of(ball.center)) - plane.offset) <= ball.radius;
}

bool meet(const Segment3& s, const Sphere3& ball) {
  return squared_distance(of(s.a), of(s.b), of(ball.center)) <= ball.radius * ball.radius;
}

bool meet(const Ray3& ray, const Sphere3& ball) {
  const V m = of(ray.origin) - of(ball.center), d = of(ray.direction);
  const double c = dot(m, m) - ball.radius * ball.radius;
  if (c <= 0) return true;
  const double b = dot(m, d);
  if (b > 0) return false;
  return b * b - c * dot(d, d) >= 0;
}

bool meet(const Triangle3& t, const Sphere3& ball) {
  const V p = of(ball.center), v = nearest_of_triangle(of(t.a), of(t.b), of(t.c), p) - p;
  return dot(v, v) <= ball.radius * ball.radius;
}

bool meet(const Aabb3& box, const Sphere3& ball) {
  return squared_distance(box, of(ball.center)) <= ball.radius * ball.radius;
}

bool meet(const Obb3& box, const Sphere3& ball) {
  const V d = of(ball.center) - of(box.center);
  const double half[3] = {box.half.x, box.half.y, box.half.z};
  V q = of(box.center);
  for (std::size_t i = 0; i < 3; ++i) {
    const V axis = of(box.axes[i]);
    q = q + axis * clamped(dot(d, axis), -half[i], half[i]);
  }
  const V v = q - of(ball.center);
  return dot(v, v) <= ball.radius * ball.radius;
}

bool meet(const Segment3& s, const Capsule3& c) {
  return squared_distance_of_segments(of(s.a), of(s.b), of(c.a), of(c.b)) <= c.radius * c.radius;
}

bool meet(const Triangle3& t, const Capsule3& capsule) {
  const V a = of(t.a), b = of(t.b), c = of(t.c), p = of(capsule.a), q = of(capsule.b);
  const double limit = capsule.radius * capsule.radius;
  for (const V& end : {p, q}) {
    const V v = nearest_of_triangle(a, b, c, end) - end;
    if (dot(v, v) <= limit) return true;
  }
  return squared_distance_of_segments(p, q, a, b) <= limit || squared_distance_of_segments(p, q, b, c) <= limit ||
         squared_distance_of_segments(p, q, c, a) <= limit || pierces(p, q, a, b, c);
}

// The ends, the edges, and whether the axis goes through.
bool meet(const Aabb3& box, const Capsule3& c) {
  const V p = of(c.a), q = of(c.b);
  const double limit = c.radius * c.radius;
  const Aabb3 grown{{box.min.x - c.radius, box.min.y - c.radius, box.min.z - c.radius},
                    {box.max.x + c.radius, box.max.y + c.radius, box.max.z + c.radius}};
  if (!crosses(grown, p, q - p)) return false;
  if (squared_distance(box, p) <= limit || squared_distance(box, q) <= limit || crosses(box, p, q - p)) return true;
  const double x[2] = {box.min.x, box.max.x}, y[2] = {box.min.y, box.max.y}, z[2] = {box.min.z, box.max.z};
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      if (squared_distance_of_segments(p, q, {x[0], y[i], z[j]}, {x[1], y[i], z[j]}) <= limit ||
          squared_distance_of_segments(p, q, {x[i], y[0], z[j]}, {x[i], y[1], z[j]}) <= limit ||
          squared_distance_of_segments(p, q, {x[i], y[j], z[0]}, {x[i], y[j], z[1]}) <= limit)
        return true;
    }
  }
  return false;
}

bool meet(const Capsule3& a, const Capsule3& b) {
  const double reach = a.radius + b.radius;
  return squared_distance_of_segments(of(a.a), of(a.b), of(b.a), of(b.b)) <= reach * reach;
}

// RTCD 5.3.7's conditions, and the ends.
bool meet(const Segment3& s, const Cylinder3& cylinder) {
  constexpr double epsilon = 1e-12;
  const V p = of(cylinder.a), d = of(cylinder.b) - p, m = of(s.a) - p, n = of(s.b) - of(s.a);
  const double md = dot(m, d), nd = dot(n, d), dd = dot(d, d);
  if (md < 0 && md + nd < 0) return false;
  if (md > dd && md + nd > dd) return false;
  const double nn = dot(n, n), mn = dot(m, n), a = dd * nn - nd * nd;
  const double k = dot(m, m) - cylinder.radius * cylinder.radius, c = dd * k - md * md;
  if (std::fabs(a) < epsilon) return c <= 0;
  const double b = dd * mn - nd * md, discriminant = b * b - a * c;
  if (discriminant < 0) return false;
  double t = (-b - std::sqrt(discriminant)) / a;
  if (t > 1 || (-b + std::sqrt(discriminant)) / a < 0) return false;
  if (t < 0) t = 0;
  if (md + t * nd < 0) {
    if (nd <= 0) return false;
    t = -md / nd;
    return t <= 1 && k + 2 * t * (mn + t * nn / 2) <= 0;
  }
  if (md + t * nd > dd) {
    if (nd >= 0) return false;
    t = (dd - md) / nd;
    return t <= 1 && k + dd - 2 * md + t * (2 * (mn - nd) + t * nn) <= 0;
  }
  return true;
}

bool meet(const Halfspace3& halfspace, const Cone3& cone) {
  const V n = of(halfspace.normal), t = of(cone.apex), base = of(cone.base), h = base - t;
  if (dot(n, t) <= halfspace.offset) return true;
  const V v = h * (1 / std::sqrt(dot(h, h))), m = cross(cross(n, v), v);
  const double length = std::sqrt(dot(m, m));
  const V q = length > 0 ? base + m * (cone.radius / length) : base;
  return dot(n, q) <= halfspace.offset;
}

}  // namespace plumb::bench::plain
