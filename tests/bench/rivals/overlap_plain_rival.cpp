// Overlap tests in plain doubles, as commonly written: intervals on the line of two planes, separating axes, slabs.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bench/rivals/overlap_rival.hpp"

namespace plumb::bench::bare {
namespace {

struct V {
  double x, y, z;
  double operator[](std::size_t k) const { return k == 0 ? x : k == 1 ? y : z; }
};
V operator-(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
V operator-(const V& a, const V& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
V vec(const Vector3& v) { return {v.x, v.y, v.z}; }
double dot(const V& a, const V& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
V cross(const V& a, const V& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

double turn(const Point2& a, const Point2& b, const Point2& c) {
  return (a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x);
}

// Two triangles by their intervals on the line of their planes, without divisions (Moller 1997).
struct Interval {
  double a, b, c, x0, x1;
};
bool interval(double v0, double v1, double v2, double d0, double d1, double d2, Interval& i) {
  const double d01 = d0 * d1, d02 = d0 * d2;
  if (d01 > 0) {
    i = {v2, (v0 - v2) * d2, (v1 - v2) * d2, d2 - d0, d2 - d1};
  } else if (d02 > 0) {
    i = {v1, (v0 - v1) * d1, (v2 - v1) * d1, d1 - d0, d1 - d2};
  } else if (d1 * d2 > 0 || d0 != 0) {
    i = {v0, (v1 - v0) * d0, (v2 - v0) * d0, d0 - d1, d0 - d2};
  } else if (d1 != 0) {
    i = {v1, (v0 - v1) * d1, (v2 - v1) * d1, d1 - d0, d1 - d2};
  } else if (d2 != 0) {
    i = {v2, (v0 - v2) * d2, (v1 - v2) * d2, d2 - d0, d2 - d1};
  } else {
    return false;
  }
  return true;
}

Point2 flat(const Point3& p, int axis) {
  return axis == 0 ? Point2{p.y, p.z} : axis == 1 ? Point2{p.z, p.x} : Point2{p.x, p.y};
}
bool coplanar(const V& n, const Triangle3& a, const Triangle3& b) {
  const double x = std::fabs(n.x), y = std::fabs(n.y), z = std::fabs(n.z);
  const int axis = x > y ? (x > z ? 0 : 2) : y > z ? 1 : 2;
  return intersects(Triangle2{flat(a.a, axis), flat(a.b, axis), flat(a.c, axis)},
                    Triangle2{flat(b.a, axis), flat(b.b, axis), flat(b.c, axis)});
}

bool box_edge(double a, double b, double va, double vb, double wa, double wb, double ha, double hb) {
  const double p = a * va - b * vb, q = a * wa - b * wb;
  const double low = std::min(p, q), high = std::max(p, q), reach = std::fabs(a) * ha + std::fabs(b) * hb;
  return low <= reach && high >= -reach;
}

// A triangle and a box around the origin (Akenine-Moller 2001).
bool in_box(const V& a, const V& b, const V& c, const V& h) {
  const std::array corner{a, b, c};
  const std::array edge{b - a, c - b, a - c};
  for (std::size_t i = 0; i < 3; ++i) {
    const V &e = edge[i], &p = corner[i], &q = corner[(i + 2) % 3];
    if (!box_edge(e.z, e.y, p.y, p.z, q.y, q.z, h.y, h.z)) return false;
    if (!box_edge(e.x, e.z, p.z, p.x, q.z, q.x, h.z, h.x)) return false;
    if (!box_edge(e.y, e.x, p.x, p.y, q.x, q.y, h.x, h.y)) return false;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::min({a[k], b[k], c[k]}) > h[k] || std::max({a[k], b[k], c[k]}) < -h[k]) return false;
  }
  const V n = cross(edge[0], edge[1]);
  const double reach = std::fabs(n.x) * h.x + std::fabs(n.y) * h.y + std::fabs(n.z) * h.z;
  return std::fabs(dot(n, a)) <= reach;
}

// A segment from m - d to m + d and a box around the origin (RTCD 5.3.3).
bool segment_in_box(const V& m, const V& d, const V& h) {
  const double x = std::fabs(d.x), y = std::fabs(d.y), z = std::fabs(d.z);
  if (std::fabs(m.x) > h.x + x || std::fabs(m.y) > h.y + y || std::fabs(m.z) > h.z + z) return false;
  if (std::fabs(m.y * d.z - m.z * d.y) > h.y * z + h.z * y) return false;
  if (std::fabs(m.z * d.x - m.x * d.z) > h.x * z + h.z * x) return false;
  return std::fabs(m.x * d.y - m.y * d.x) <= h.x * y + h.y * x;
}
V half(const Aabb3& box) {
  return {(box.max.x - box.min.x) * 0.5, (box.max.y - box.min.y) * 0.5, (box.max.z - box.min.z) * 0.5};
}
Point3 center(const Aabb3& box) {
  return {(box.min.x + box.max.x) * 0.5, (box.min.y + box.max.y) * 0.5, (box.min.z + box.max.z) * 0.5};
}
// Of orthonormal axes.
V local(const Obb3& box, const V& v) {
  return {dot(v, vec(box.axes[0])), dot(v, vec(box.axes[1])), dot(v, vec(box.axes[2]))};
}

// All normals of faces and cross products of edges.
template <std::size_t n, std::size_t m>
bool separates(const V& axis, const std::array<Point3, n>& a, const std::array<Point3, m>& b) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double low_a = infinity, high_a = -infinity, low_b = infinity, high_b = -infinity;
  for (const Point3& p : a) {
    const double x = axis.x * p.x + axis.y * p.y + axis.z * p.z;
    low_a = std::min(low_a, x), high_a = std::max(high_a, x);
  }
  for (const Point3& p : b) {
    const double x = axis.x * p.x + axis.y * p.y + axis.z * p.z;
    low_b = std::min(low_b, x), high_b = std::max(high_b, x);
  }
  return low_a > high_b || low_b > high_a;
}
template <std::size_t n, std::size_t m>
bool meet(const std::array<Point3, n>& a, const std::array<Point3, m>& b) {
  const auto faces = [&](const auto& of) {
    if constexpr (std::tuple_size_v<std::remove_cvref_t<decltype(of)>> == 3) {
      return separates(cross(of[1] - of[0], of[2] - of[0]), a, b);
    } else {
      return separates(cross(of[1] - of[0], of[2] - of[0]), a, b) ||
             separates(cross(of[1] - of[0], of[3] - of[0]), a, b) ||
             separates(cross(of[2] - of[0], of[3] - of[0]), a, b) ||
             separates(cross(of[2] - of[1], of[3] - of[1]), a, b);
    }
  };
  if (faces(a) || faces(b)) return false;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      for (std::size_t k = 0; k < m; ++k) {
        for (std::size_t l = k + 1; l < m; ++l) {
          if (separates(cross(a[j] - a[i], b[l] - b[k]), a, b)) return false;
        }
      }
    }
  }
  return true;
}

}  // namespace

bool intersects(const Triangle3& a, const Triangle3& b) {
  const V n = cross(a.b - a.a, a.c - a.a);
  const double u0 = dot(n, b.a - a.a), u1 = dot(n, b.b - a.a), u2 = dot(n, b.c - a.a);
  if (u0 * u1 > 0 && u0 * u2 > 0) return false;
  const V m = cross(b.b - b.a, b.c - b.a);
  const double v0 = dot(m, a.a - b.a), v1 = dot(m, a.b - b.a), v2 = dot(m, a.c - b.a);
  if (v0 * v1 > 0 && v0 * v2 > 0) return false;
  const V d = cross(n, m);
  const double x = std::fabs(d.x), y = std::fabs(d.y), z = std::fabs(d.z);
  const auto at = [&](const Point3& p) { return x >= y && x >= z ? p.x : y >= z ? p.y : p.z; };
  Interval i{}, j{};
  if (!interval(at(a.a), at(a.b), at(a.c), v0, v1, v2, i)) return coplanar(n, a, b);
  if (!interval(at(b.a), at(b.b), at(b.c), u0, u1, u2, j)) return coplanar(n, a, b);
  const double xx = i.x0 * i.x1, yy = j.x0 * j.x1, all = xx * yy;
  double t = i.a * all;
  double p0 = t + i.b * i.x1 * yy, p1 = t + i.c * i.x0 * yy;
  t = j.a * all;
  double q0 = t + j.b * xx * j.x1, q1 = t + j.c * xx * j.x0;
  if (p0 > p1) std::swap(p0, p1);
  if (q0 > q1) std::swap(q0, q1);
  return p1 >= q0 && q1 >= p0;
}

bool intersects(const Segment3& s, const Triangle3& t) {  // Moller and Trumbore 1997
  const V e = t.b - t.a, f = t.c - t.a, d = s.b - s.a;
  const V p = cross(d, f);
  const double det = dot(e, p);
  if (det == 0) return false;
  const double inverse = 1 / det;
  const V w = s.a - t.a;
  const double u = dot(w, p) * inverse;
  if (u < 0 || u > 1) return false;
  const V q = cross(w, e);
  const double v = dot(d, q) * inverse;
  if (v < 0 || u + v > 1) return false;
  const double r = dot(f, q) * inverse;
  return r >= 0 && r <= 1;
}

bool intersects(const Ray3& ray, const Triangle3& t) {
  const V e = t.b - t.a, f = t.c - t.a, d = vec(ray.direction);
  const V p = cross(d, f);
  const double det = dot(e, p);
  if (det == 0) return false;
  const double inverse = 1 / det;
  const V w = ray.origin - t.a;
  const double u = dot(w, p) * inverse;
  if (u < 0 || u > 1) return false;
  const V q = cross(w, e);
  const double v = dot(d, q) * inverse;
  if (v < 0 || u + v > 1) return false;
  return dot(f, q) * inverse >= 0;
}

bool intersects(const Triangle3& t, const Aabb3& box) {
  const Point3 c = center(box);
  return in_box(t.a - c, t.b - c, t.c - c, half(box));
}
bool intersects(const Triangle3& t, const Obb3& box) {
  return in_box(local(box, t.a - box.center), local(box, t.b - box.center), local(box, t.c - box.center),
                vec(box.half));
}

bool intersects(const Segment3& s, const Aabb3& box) {
  const Point3 c = center(box), mid{(s.a.x + s.b.x) * 0.5, (s.a.y + s.b.y) * 0.5, (s.a.z + s.b.z) * 0.5};
  return segment_in_box(mid - c, s.b - mid, half(box));
}
bool intersects(const Segment3& s, const Obb3& box) {
  const Point3 mid{(s.a.x + s.b.x) * 0.5, (s.a.y + s.b.y) * 0.5, (s.a.z + s.b.z) * 0.5};
  return segment_in_box(local(box, mid - box.center), local(box, s.b - mid), vec(box.half));
}

bool intersects(const Ray3& r, const Aabb3& box) {  // slabs
  double from = 0, to = std::numeric_limits<double>::infinity();
  const V d = vec(r.direction);
  const std::array o{r.origin.x, r.origin.y, r.origin.z}, low{box.min.x, box.min.y, box.min.z},
      high{box.max.x, box.max.y, box.max.z};
  for (std::size_t k = 0; k < 3; ++k) {
    if (d[k] == 0) {
      if (o[k] < low[k] || o[k] > high[k]) return false;
      continue;
    }
    const double inverse = 1 / d[k];
    double in = (low[k] - o[k]) * inverse, out = (high[k] - o[k]) * inverse;
    if (in > out) std::swap(in, out);
    from = std::max(from, in), to = std::min(to, out);
    if (from > to) return false;
  }
  return true;
}

bool intersects(const Aabb3& a, const Aabb3& b) {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y && a.min.z <= b.max.z &&
         b.min.z <= a.max.z;
}

bool intersects(const Aabb3& a, const Obb3& b) {
  constexpr double epsilon = 1e-12;
  const V h = half(a), k = vec(b.half), t = b.center - center(a);
  const std::array r{vec(b.axes[0]), vec(b.axes[1]), vec(b.axes[2])};
  std::array<V, 3> s{};
  for (std::size_t j = 0; j < 3; ++j)
    s[j] = {std::fabs(r[j].x) + epsilon, std::fabs(r[j].y) + epsilon, std::fabs(r[j].z) + epsilon};
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::fabs(t[i]) > h[i] + k.x * s[0][i] + k.y * s[1][i] + k.z * s[2][i]) return false;
  }
  for (std::size_t j = 0; j < 3; ++j) {
    if (std::fabs(dot(t, r[j])) > dot(h, s[j]) + k[j]) return false;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      const double reach = h[i1] * s[j][i2] + h[i2] * s[j][i1] + k[j1] * s[j2][i] + k[j2] * s[j1][i];
      if (std::fabs(t[i2] * r[j][i1] - t[i1] * r[j][i2]) > reach) return false;
    }
  }
  return true;
}

bool intersects(const Plane3& plane, const Aabb3& box) {
  const Point3 c = center(box);
  const V h = half(box), n = vec(plane.normal);
  const double reach = h.x * std::fabs(n.x) + h.y * std::fabs(n.y) + h.z * std::fabs(n.z);
  return std::fabs(n.x * c.x + n.y * c.y + n.z * c.z - plane.offset) <= reach;
}
bool intersects(const Plane3& plane, const Triangle3& t) {
  const V n = vec(plane.normal);
  const auto side = [&](const Point3& p) { return n.x * p.x + n.y * p.y + n.z * p.z - plane.offset; };
  const double a = side(t.a), b = side(t.b), c = side(t.c);
  return std::min({a, b, c}) <= 0 && std::max({a, b, c}) >= 0;
}

bool intersects(const Tetrahedron3& a, const Tetrahedron3& b) {
  return meet(std::array{a.a, a.b, a.c, a.d}, std::array{b.a, b.b, b.c, b.d});
}
bool intersects(const Triangle3& a, const Tetrahedron3& b) {
  return meet(std::array{a.a, a.b, a.c}, std::array{b.a, b.b, b.c, b.d});
}

bool intersects(const Segment2& s, const Segment2& t) {  // RTCD 5.1.9.1
  const double a = turn(s.a, s.b, t.b), b = turn(s.a, s.b, t.a);
  if (a * b > 0) return false;
  const double c = turn(t.a, t.b, s.a), d = c + b - a;
  return c * d <= 0;
}

bool intersects(const Triangle2& a, const Triangle2& b) {
  const auto separates = [](const Triangle2& of, const Triangle2& other) {
    const double way = turn(of.a, of.b, of.c);
    const std::array p{of.a, of.b, of.c};
    for (std::size_t i = 0; i < 3; ++i) {
      const Point2 &from = p[i], &to = p[(i + 1) % 3];
      if (turn(from, to, other.a) * way < 0 && turn(from, to, other.b) * way < 0 && turn(from, to, other.c) * way < 0)
        return true;
    }
    return false;
  };
  return !separates(a, b) && !separates(b, a);
}

bool intersects(const Segment2& s, const Triangle2& t) {
  const double a = turn(s.a, s.b, t.a), b = turn(s.a, s.b, t.b), c = turn(s.a, s.b, t.c);
  if ((a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0)) return false;
  const double way = turn(t.a, t.b, t.c);
  const std::array p{t.a, t.b, t.c};
  for (std::size_t i = 0; i < 3; ++i) {
    const Point2 &from = p[i], &to = p[(i + 1) % 3];
    if (turn(from, to, s.a) * way < 0 && turn(from, to, s.b) * way < 0) return false;
  }
  return true;
}

bool intersects(const Triangle2& t, const Aabb2& box) {
  if (std::min({t.a.x, t.b.x, t.c.x}) > box.max.x || std::max({t.a.x, t.b.x, t.c.x}) < box.min.x) return false;
  if (std::min({t.a.y, t.b.y, t.c.y}) > box.max.y || std::max({t.a.y, t.b.y, t.c.y}) < box.min.y) return false;
  const double cx = (box.min.x + box.max.x) * 0.5, cy = (box.min.y + box.max.y) * 0.5;
  const double hx = (box.max.x - box.min.x) * 0.5, hy = (box.max.y - box.min.y) * 0.5;
  const std::array p{t.a, t.b, t.c};
  for (std::size_t i = 0; i < 3; ++i) {
    const Point2 &u = p[i], &v = p[(i + 1) % 3], &w = p[(i + 2) % 3];
    const double nx = u.y - v.y, ny = v.x - u.x;
    const double at = nx * (u.x - cx) + ny * (u.y - cy), across = nx * (w.x - cx) + ny * (w.y - cy);
    const double reach = std::fabs(nx) * hx + std::fabs(ny) * hy;
    if (std::min(at, across) > reach || std::max(at, across) < -reach) return false;
  }
  return true;
}

}  // namespace plumb::bench::bare
