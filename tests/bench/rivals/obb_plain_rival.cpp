// The separating-axis test of oriented boxes in plain doubles.
#include <cmath>

#include "bench/rivals/obb_rival.hpp"

namespace plumb::bench {
namespace {

double dot(const Vector3& u, const Vector3& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }

}  // namespace

bool boxes_meet_in_doubles(const Obb3& a, const Obb3& b) {
  constexpr double epsilon = 1e-12;
  const double p[3] = {a.half.x, a.half.y, a.half.z}, q[3] = {b.half.x, b.half.y, b.half.z};
  double r[3][3], s[3][3];
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      r[i][j] = dot(a.axes[i], b.axes[j]);
      s[i][j] = std::fabs(r[i][j]) + epsilon;
    }
  }
  const Vector3 d{b.center.x - a.center.x, b.center.y - a.center.y, b.center.z - a.center.z};
  const double t[3] = {dot(d, a.axes[0]), dot(d, a.axes[1]), dot(d, a.axes[2])};
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::fabs(t[i]) > p[i] + q[0] * s[i][0] + q[1] * s[i][1] + q[2] * s[i][2]) return false;
  }
  for (std::size_t j = 0; j < 3; ++j) {
    const double far = std::fabs(t[0] * r[0][j] + t[1] * r[1][j] + t[2] * r[2][j]);
    if (far > p[0] * s[0][j] + p[1] * s[1][j] + p[2] * s[2][j] + q[j]) return false;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      const double reach = p[i1] * s[i2][j] + p[i2] * s[i1][j] + q[j1] * s[i][j2] + q[j2] * s[i][j1];
      if (std::fabs(t[i2] * r[i1][j] - t[i1] * r[i2][j]) > reach) return false;
    }
  }
  return true;
}

}  // namespace plumb::bench
