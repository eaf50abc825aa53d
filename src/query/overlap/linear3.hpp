// Segment intersection: how do lines, rays and segments in space lie to one another, to points and to triangles?
// Degenerate ones too.
//
// Laws: one of zero direction, or of equal ends, is its point; a triangle without area is a segment or a point.  What
// lies in one plane is looked at along an axis in which that plane is not seen edge on, by the signs of the plane.
// Source: RTCD 5.3.4, 5.3.6, 5.1.9.1.
// Cost: five signs of degree 3; in one plane some ten of degree 2.
#pragma once

#include "plumb/query/body/detail/question.hpp"
#include "query/overlap/shapes2.hpp"

namespace plumb::query {

/// Seen along axis k; 0, 1, 2 for x, y, z.
constexpr Point2 seen(const Point3& p, std::size_t k) {
  return k == 0 ? Point2{p.y, p.z} : k == 1 ? Point2{p.z, p.x} : Point2{p.x, p.y};
}
constexpr Triangle2 seen(const Triangle3& t, std::size_t k) { return {seen(t.a, k), seen(t.b, k), seen(t.c, k)}; }

struct Linear3 {
  LinearKind reach;
  bool by_points;  // as of Linear2
  Point3 p, q;

  static Linear3 through(LinearKind reach, const Point3& p, const Point3& q) { return {reach, true, p, q}; }
  static Linear3 along(LinearKind reach, const Point3& p, const Vector3& d) {
    return {reach, false, p, {d.x, d.y, d.z}};
  }

  [[nodiscard]] Vector3 direction() const { return {q.x, q.y, q.z}; }  // unless by points
  [[nodiscard]] bool is_point() const { return by_points ? p == q : direction() == Vector3{0, 0, 0}; }
  [[nodiscard]] Linear2 seen_along(std::size_t k) const { return {reach, by_points, seen(p, k), seen(q, k)}; }
};

inline Linear3 linear(const Line3& l) { return Linear3::along(LinearKind::line, l.point, l.direction); }
inline Linear3 linear(const Ray3& r) { return Linear3::along(LinearKind::ray, r.origin, r.direction); }
inline Linear3 linear(const Segment3& s) { return Linear3::through(LinearKind::segment, s.a, s.b); }

/// The axis along which most is seen of a plane with this normal.
constexpr std::size_t axis_across(double x, double y, double z) {
  const double of_x = magnitude_of(x), of_y = magnitude_of(y), of_z = magnitude_of(z);
  return of_x > of_y ? (of_x > of_z ? 0 : 2) : of_y > of_z ? 1 : 2;
}
/// The axis along which doubles see most of the triangle.
std::size_t likely_axis(const Triangle3& t);
/// An axis along which the triangle has an area; 3 when it has none.
std::size_t telling_axis(const Triangle3& t);

/// The segment or point that a triangle without area is.
Linear3 flattened(const Triangle3& t);

Relation relate(const Linear3& a, const Linear3& b);
Relation relate(const Linear3& a, const Triangle3& b);
Relation relate(const Triangle3& a, const Triangle3& b, Question question = {});

}  // namespace plumb::query
