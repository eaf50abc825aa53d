#include "plumb/query/section/intersection_result.hpp"

#include "plumb/predicates.hpp"

namespace plumb {
namespace {

bool on_line(const ExactPoint2& a, const ExactPoint2& b, const ExactPoint2& p) {
  return orient2d(a, b, p) == Sign::zero;
}
bool on_line(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& p) { return collinear(a, b, p); }

Sign order(const ExactPoint2& a, const ExactPoint2& b) { return compare_xy(a, b); }
Sign order(const ExactPoint3& a, const ExactPoint3& b) { return compare_xyz(a, b); }

template <class Common>
bool equal(const Common& a, const Common& b) {
  if (a.kind != b.kind || a.vertices.size() != b.vertices.size()) return false;
  const auto &p = a.vertices, &q = b.vertices;
  if (a.kind == IntersectionKind::line) return on_line(p[0], p[1], q[0]) && on_line(p[0], p[1], q[1]);
  if (a.kind == IntersectionKind::ray)
    return p[0] == q[0] && on_line(p[0], p[1], q[1]) && order(p[0], p[1]) == order(q[0], q[1]);
  return p == q;
}

template <class Point, class Common>
std::vector<Point> nearest(const Common& a) {
  std::vector<Point> points;
  points.reserve(a.vertices.size());
  for (const auto& p : a.vertices) points.push_back(approximate(p));
  return points;
}

}  // namespace

std::vector<Point2> approximate(const Intersection2& a) { return nearest<Point2>(a); }
std::vector<Point3> approximate(const Intersection3& a) { return nearest<Point3>(a); }

bool operator==(const Intersection2& a, const Intersection2& b) { return equal(a, b); }
bool operator==(const Intersection3& a, const Intersection3& b) { return equal(a, b); }

}  // namespace plumb
