// What do users hand over?  Functions of the documented C signatures: right ones by the library's other questions, and
// wrong ones as software has them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "plumb/plumb.hpp"

namespace plumb_test::foreign {

inline plumb::Point2 point2(const double* p) { return {p[0], p[1]}; }
inline plumb::Point3 point3(const double* p) { return {p[0], p[1], p[2]}; }
inline plumb::Vector3 vector3(const double* p) { return {p[0], p[1], p[2]}; }
inline plumb::Triangle3 triangle(const double* p) { return {point3(p), point3(p + 3), point3(p + 6)}; }
inline plumb::Obb3 oriented_box(const double* p) {
  return {point3(p), {vector3(p + 3), vector3(p + 6), vector3(p + 9)}, vector3(p + 12)};
}
inline double number(plumb::Sign s) { return static_cast<int>(s); }

inline double orient2d(const double* a, const double* b, const double* c) {
  return number(plumb::orient2d(point2(a), point2(b), point2(c)));
}
inline double orient3d(const double* a, const double* b, const double* c, const double* d) {
  return number(plumb::orient3d(point3(a), point3(b), point3(c), point3(d)));
}
inline double incircle(const double* a, const double* b, const double* c, const double* d) {
  return number(plumb::incircle(point2(a), point2(b), point2(c), point2(d)));
}
inline double insphere(const double* a, const double* b, const double* c, const double* d, const double* e) {
  return number(plumb::insphere(point3(a), point3(b), point3(c), point3(d), point3(e)));
}
inline int segment_segment(const double* a, const double* b) {
  return intersects(plumb::Segment2{point2(b), point2(b + 2)}, plumb::Segment2{point2(a), point2(a + 2)}) ? 1 : 0;
}
inline int segment_segment_3d(const double* a, const double* b) {
  const auto common =
      intersection(plumb::Segment3{point3(a), point3(a + 3)}, plumb::Segment3{point3(b), point3(b + 3)});
  return common.kind == plumb::IntersectionKind::nothing ? 0 : -1;
}
inline int triangle_triangle(const double* a, const double* b) {
  return intersection(triangle(a), triangle(b)).kind == plumb::IntersectionKind::nothing ? 0 : 2;
}
inline int ray_triangle(const double* ray, const double* other, double* t) {
  const auto hit = first_hit_parameter(plumb::Ray3{point3(ray), vector3(ray + 3)}, triangle(other));
  if (hit) *t = hit->rounded();
  return hit ? 1 : 0;
}
inline int ray_hits_triangle(const double* ray, const double* other, double*) {
  return hits(plumb::Ray3{point3(ray), vector3(ray + 3)}, triangle(other)) ? 1 : 0;
}
inline int point_in_polygon(const double* p, const double* vertices, std::size_t n) {
  plumb::Polygon2 polygon;  // from the last vertex to the first
  for (std::size_t i = n; i > 0; --i) polygon.vertices.push_back(point2(vertices + 2 * (i - 1)));
  return locate(polygon, point2(p)) == plumb::Location::outside ? 0 : 1;
}
inline plumb::TriangleMesh mesh(const double* vertices, std::size_t n, const std::size_t* triangles, std::size_t m) {
  plumb::TriangleMesh made;
  for (std::size_t i = 0; i < n; ++i) made.vertices.push_back(point3(vertices + 3 * i));
  const auto index = [&](std::size_t i) { return static_cast<std::uint32_t>(triangles[i]); };
  for (std::size_t i = 0; i < 3 * m; i += 3) made.triangles.push_back({index(i), index(i + 1), index(i + 2)});
  return made;
}
inline int ray_mesh(const double* ray, const double* vertices, std::size_t n, const std::size_t* triangles,
                    std::size_t m, double* t) {
  const auto hit = first_hit(plumb::Ray3{point3(ray), vector3(ray + 3)}, mesh(vertices, n, triangles, m));
  if (hit) *t = hit->hit.t;
  return hit ? 1 : 0;
}
// Along another axis, the last triangle first.
inline int point_in_polyhedron(const double* p, const double* vertices, std::size_t n, const std::size_t* triangles,
                               std::size_t m) {
  plumb::TriangleMesh made = mesh(vertices, n, triangles, m);
  for (plumb::Point3& v : made.vertices) v = {v.z, v.x, v.y};
  std::reverse(made.triangles.begin(), made.triangles.end());
  return locate(made, {p[2], p[0], p[1]}) == plumb::Location::outside ? 0 : 1;
}
inline int box_box(const double* a, const double* b) {
  for (int k = 0; k < 3; ++k) {
    if (a[k] > b[3 + k] || b[k] > a[3 + k]) return 0;
  }
  return 1;
}
inline int obb_obb(const double* a, const double* b) {
  return relate(oriented_box(b), oriented_box(a)) == plumb::Relation::disjoint ? 0 : 1;
}
// The facets of the hull, the last point first; faces in one plane are fans.
inline std::size_t hull(const double* points, std::size_t n, std::size_t* triangles, std::size_t capacity) {
  std::vector<plumb::Point3> all;
  for (std::size_t i = n; i > 0; --i) all.push_back(point3(points + 3 * (i - 1)));
  const plumb::Hull3 made = plumb::convex_hull(all);
  std::size_t count = 0;
  if (made.dimension < 3) return 0;
  for (std::size_t f = 0; f < made.face_count(); ++f) {
    const auto face = made.face(f);
    for (std::size_t k = 1; k + 1 < face.size(); ++k, ++count) {
      if (count == capacity) return std::numeric_limits<std::size_t>::max();
      triangles[3 * count] = n - 1 - face[0];
      triangles[3 * count + 1] = n - 1 - face[k];
      triangles[3 * count + 2] = n - 1 - face[k + 1];
    }
  }
  return count;
}

// As software has it.
inline double naive_orient3d(const double* a, const double* b, const double* c, const double* d) {
  const double ax = a[0] - d[0], ay = a[1] - d[1], az = a[2] - d[2];
  const double bx = b[0] - d[0], by = b[1] - d[1], bz = b[2] - d[2];
  const double cx = c[0] - d[0], cy = c[1] - d[1], cz = c[2] - d[2];
  return ax * (by * cz - bz * cy) + bx * (cy * az - cz * ay) + cx * (ay * bz - az * by);
}
// A separating plane among those of the faces, with an epsilon: what touches may be told apart, and what is apart
// may be told to touch.
inline int epsilon_triangle_triangle(const double* a, const double* b) {
  constexpr double epsilon = 1e-9;
  const auto beyond = [&](const double* t, const double* other) {
    int below = 0, above = 0;
    for (int i = 0; i < 3; ++i) {
      const double h = naive_orient3d(t, t + 3, t + 6, other + 3 * i);
      below += h < -epsilon ? 1 : 0;
      above += h > epsilon ? 1 : 0;
    }
    return below == 3 || above == 3;
  };
  return beyond(a, b) || beyond(b, a) ? 0 : 1;
}
// The crossing number, with half-open edges: points on the boundary are in or out as it happens.
inline int crossing_number(const double* p, const double* v, std::size_t n) {
  bool inside = false;
  for (std::size_t i = 0, j = n - 1; i < n; j = i++) {
    if ((v[2 * i + 1] > p[1]) != (v[2 * j + 1] > p[1]) &&
        p[0] < (v[2 * j] - v[2 * i]) * (p[1] - v[2 * i + 1]) / (v[2 * j + 1] - v[2 * i + 1]) + v[2 * i]) {
      inside = !inside;
    }
  }
  return inside ? 1 : 0;
}
struct Crossing {
  double u, v, t;
};
// Moeller and Trumbore's test, whatever the crossing's place: nothing where the determinant is zero.
inline bool crosses(const double* ray, const double* a, const double* b, const double* c, Crossing& at) {
  const auto minus = [](const double* p, const double* q) {
    return plumb::Vector3{p[0] - q[0], p[1] - q[1], p[2] - q[2]};
  };
  const auto cross = [](const plumb::Vector3& p, const plumb::Vector3& q) {
    return plumb::Vector3{p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
  };
  const auto dot = [](const plumb::Vector3& p, const plumb::Vector3& q) { return p.x * q.x + p.y * q.y + p.z * q.z; };
  const plumb::Vector3 e = minus(b, a), f = minus(c, a), s = minus(ray, a), d = vector3(ray + 3), p = cross(d, f);
  const double det = dot(e, p);
  if (det == 0) return false;
  const plumb::Vector3 r = cross(s, e);
  at = {dot(s, p) / det, dot(d, r) / det, dot(f, r) / det};
  return true;
}
// Triangles without their edges: rays leak where two meet.
inline int leaking_ray_mesh(const double* ray, const double* vertices, std::size_t, const std::size_t* triangles,
                            std::size_t m, double* t) {
  int hit = 0;
  Crossing at{};
  for (const std::size_t* i = triangles; i < triangles + 3 * m; i += 3) {
    if (!crosses(ray, vertices + 3 * i[0], vertices + 3 * i[1], vertices + 3 * i[2], at)) continue;
    if (at.u <= 0 || at.v <= 0 || at.u + at.v >= 1 || at.t < 0 || (hit != 0 && at.t >= *t)) continue;
    hit = 1;
    *t = at.t;
  }
  return hit;
}
// Triangles with their edges, counted along x: edges and vertices count more than once.
inline int counting_in_polyhedron(const double* p, const double* vertices, std::size_t, const std::size_t* triangles,
                                  std::size_t m) {
  const double ray[] = {p[0], p[1], p[2], 1, 0, 0};
  std::size_t count = 0;
  Crossing at{};
  for (const std::size_t* i = triangles; i < triangles + 3 * m; i += 3) {
    if (!crosses(ray, vertices + 3 * i[0], vertices + 3 * i[1], vertices + 3 * i[2], at)) continue;
    if (at.u < 0 || at.v < 0 || at.u + at.v > 1 || at.t < 0) continue;
    if (at.t == 0) return 1;
    ++count;
  }
  return count % 2 == 1 ? 1 : 0;
}
// The nearest pair of vertices, which is not the nearest pair of points.
inline double vertex_distance(const double* a, std::size_t n, const double* b, std::size_t m) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < m; ++j) {
      least =
          std::fmin(least, std::hypot(a[3 * i] - b[3 * j], a[3 * i + 1] - b[3 * j + 1], a[3 * i + 2] - b[3 * j + 2]));
    }
  }
  return least;
}

}  // namespace plumb_test::foreign
