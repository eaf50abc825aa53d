// Which poses are figures asked under?  Turned, sheared, mirrored, of extreme size, exact ones of small numbers, and
// singular ones.
#pragma once

#include <cmath>

#include "plumb/arith/pose.hpp"
#include "query/body/pair_moves.hpp"

namespace plumb::pair_cases {

inline double determinant(const Pose& pose) {
  const auto& [u, v, w] = pose.columns;
  return u.x * (v.y * w.z - v.z * w.y) - u.y * (v.x * w.z - v.z * w.x) + u.z * (v.x * w.y - v.y * w.x);
}
inline double determinant(const Pose2& pose) {
  const auto& [u, v] = pose.columns;
  return u.x * v.y - u.y * v.x;
}

/// Whole numbers from -3 to 3.
inline Pose whole_pose(Material& m) {
  const auto n = [&] { return static_cast<double>(m.below(7)) - 3; };
  return {{{{n(), n(), n()}, {n(), n(), n()}, {n(), n(), n()}}}, {n(), n(), n()}};
}
inline Pose2 in_plane(const Pose& p) {
  return {{{{p.columns[0].x, p.columns[0].y}, {p.columns[1].x, p.columns[1].y}}}, {p.translation.x, p.translation.y}};
}

/// Not singular; about one axis where it turns, so that it is a pose of the plane as well.
inline Pose regular_pose(Material& m) {
  const auto kind = m.below(4);
  if (kind == 0) {
    for (;;) {
      const Pose pose = whole_pose(m);
      if (determinant(pose) != 0 && determinant(in_plane(pose)) != 0) return pose;
    }
  }
  const double angle = 0.1 * static_cast<double>(1 + m.below(60)), c = std::cos(angle), s = std::sin(angle);
  const double size = kind == 1 ? 1 : std::ldexp(1.0, static_cast<int>(m.below(5)) * 300 - 600);
  const double z = m.below(2) == 0 ? size : -size, shear = kind == 3 ? 0.3 * size : 0;
  const double far = kind == 1 ? 1e9 : size;
  return {{{{c * size, s * size, 0}, {-s * size + shear, c * size, 0}, {0, shear, z}}}, {0.1 * far, far / 3, 0.7}};
}

/// Of rank 0, 1 or 2.
inline Pose singular_pose(Material& m) {
  Pose pose = whole_pose(m);
  auto& c = pose.columns;
  const double k = static_cast<double>(m.below(7)) - 3, l = static_cast<double>(m.below(7)) - 3;
  c[2] = {k * c[0].x + l * c[1].x, k * c[0].y + l * c[1].y, k * c[0].z + l * c[1].z};
  if (m.below(4) == 0) c[1] = c[2] = {};
  if (m.below(8) == 0) c[0] = {};
  std::swap(c[m.below(3)], c[m.below(3)]);
  return pose;
}
/// Of rank 0 or 1.
inline Pose2 singular_pose2(Material& m) {
  Pose2 pose = in_plane(whole_pose(m));
  auto& c = pose.columns;
  const double k = static_cast<double>(m.below(5)) - 2;
  c[1] = {k * c[0].x, k * c[0].y};
  if (m.below(8) == 0) c = {};
  if (m.below(2) == 0) std::swap(c[0], c[1]);
  return pose;
}

/// The pose that a map is.
inline Pose pose_of(Map& map) {
  return {{{map.vector(Vector3{1, 0, 0}), map.vector(Vector3{0, 1, 0}), map.vector(Vector3{0, 0, 1})}}, [&] {
            const Point3 p = map.point(Point3{0, 0, 0});
            return Vector3{p.x, p.y, p.z};
          }()};
}

}  // namespace plumb::pair_cases
