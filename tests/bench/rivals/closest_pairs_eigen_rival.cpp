// Closest points of segments with Eigen's vectors.
#include <Eigen/Core>
#include <algorithm>

#include "bench/rivals/closest_pairs_rival.hpp"

namespace plumb::bench {

double segments_in_eigen(const Segment3& p, const Segment3& q) {
  using Eigen::Vector3d;
  const Vector3d pa(p.a.x, p.a.y, p.a.z), pb(p.b.x, p.b.y, p.b.z), qa(q.a.x, q.a.y, q.a.z), qb(q.b.x, q.b.y, q.b.z);
  const Vector3d u = pb - pa, v = qb - qa, r = pa - qa;
  const double a = u.squaredNorm(), e = v.squaredNorm(), b = u.dot(v), c = u.dot(r), f = v.dot(r);
  const double denominator = a * e - b * b;
  double s = denominator > 1e-12 * a * e ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0) : 0;
  double t = (b * s + f) / e;
  if (t < 0) {
    t = 0;
    s = std::clamp(-c / a, 0.0, 1.0);
  } else if (t > 1) {
    t = 1;
    s = std::clamp((b - c) / a, 0.0, 1.0);
  }
  return (pa + s * u - qa - t * v).norm();
}

}  // namespace plumb::bench
