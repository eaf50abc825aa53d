// Nearest points by Eigen: lines, boxes and small solves of its own.
#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>

#include "bench/rivals/closest_rival.hpp"

namespace plumb::bench {
namespace {

using Vec = Eigen::Vector3d;
Vec of(const Point3& p) { return {p.x, p.y, p.z}; }
Vec of(const Vector3& p) { return {p.x, p.y, p.z}; }
NearestFound found(const Vec& q, const Vec& p) { return {{q.x(), q.y(), q.z()}, (p - q).norm()}; }

Vec on_segment(const Vec& a, const Vec& b, const Vec& p) {
  const Vec d = b - a;
  const double whole = d.squaredNorm();
  return whole == 0 ? a : Vec(a + std::clamp((p - a).dot(d) / whole, 0.0, 1.0) * d);
}

}  // namespace

NearestFound nearest_by_eigen(const Segment3& s, const Point3& p) {
  return found(on_segment(of(s.a), of(s.b), of(p)), of(p));
}

NearestFound nearest_by_eigen(const Triangle3& t, const Point3& p) {
  const Vec a = of(t.a), b = of(t.b), c = of(t.c), q = of(p);
  Eigen::Matrix<double, 3, 2> edges;
  edges << b - a, c - a;
  const Eigen::Vector2d st = (edges.transpose() * edges).ldlt().solve(edges.transpose() * (q - a));
  if (st.x() >= 0 && st.y() >= 0 && st.sum() <= 1) return found(a + edges * st, q);
  const NearestFound all[] = {found(on_segment(a, b, q), q), found(on_segment(b, c, q), q),
                              found(on_segment(c, a, q), q)};
  return *std::ranges::min_element(all, {}, &NearestFound::distance);
}

NearestFound nearest_by_eigen(const Aabb3& box, const Point3& p) {
  const Vec q = of(p);
  return found(q.cwiseMax(of(box.min)).cwiseMin(of(box.max)), q);
}

NearestFound nearest_by_eigen(const Obb3& box, const Point3& p) {
  Eigen::Matrix3d axes;
  axes << of(box.axes[0]), of(box.axes[1]), of(box.axes[2]);
  const Vec center = of(box.center), half = of(box.half), q = of(p);
  const Vec local = axes.transpose() * (q - center);
  return found(center + axes * local.cwiseMax(-half).cwiseMin(half), q);
}

}  // namespace plumb::bench
