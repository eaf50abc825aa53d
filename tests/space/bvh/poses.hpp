// Which poses must a mesh be asked under?  And where are the posed vertices, in rationals?
//
// Maps of small integers that keep lattices (turns, mirrors, shears), the same that flatten to a plane, a line or a
// point, rotations as doubles have them, and columns of extreme exponents.
#pragma once

#include <gmpxx.h>

#include <cmath>
#include <optional>

#include "figure/basic/shape_cases.hpp"
#include "plumb/arith/pose.hpp"
#include "plumb/figure/basic/mesh.hpp"
#include "plumb/space/bvh/posed_mesh.hpp"

namespace plumb::poses {

using shape_cases::Material;

inline Pose integer_pose(Material& m) {
  Pose pose{};
  const auto small = [&] { return static_cast<double>(m.entropy().within(2)); };
  const std::size_t kind = m.below(4);
  if (kind == 0) {  // axes permuted and mirrored
    const std::size_t first = m.below(3), way = 1 + m.below(2);
    const auto one = [&](std::size_t axis) {
      const double x = m.below(2) == 0 ? 1 : -1;
      return axis == 0 ? Vector3{x, 0, 0} : axis == 1 ? Vector3{0, x, 0} : Vector3{0, 0, x};
    };
    pose.columns = {one(first), one((first + way) % 3), one((first + 2 * way) % 3)};
  } else {
    for (Vector3& c : pose.columns) c = {small(), small(), small()};
  }
  if (kind == 2) pose.columns[2] = {0, 0, 0};  // at most a plane
  if (kind == 3 && m.below(3) == 0) {          // at most a line
    pose.columns[1] = {-pose.columns[0].x, -pose.columns[0].y, -pose.columns[0].z};
    pose.columns[2] = m.below(2) == 0 ? pose.columns[0] : Vector3{0, 0, 0};
    if (m.below(3) == 0) pose.columns = {};
  }
  if (m.below(2) == 0) pose.translation = {m.number(), m.number(), m.number()};
  return pose;
}

/// A rotation, rounded.
inline Pose turn(Material& m) {
  const auto angle = [&] { return static_cast<double>(m.entropy().within(1000)) / 100; };
  const double a = angle(), b = angle();
  const Vector3 x{std::cos(a), std::sin(a) * std::cos(b), std::sin(a) * std::sin(b)};
  const Vector3 y{-std::sin(a), std::cos(a) * std::cos(b), std::cos(a) * std::sin(b)};
  const Vector3 z{0, -std::sin(b), std::cos(b)};
  return {{{x, y, z}}, {m.number(), m.number() / 3, m.number()}};
}

inline Pose extreme_pose(Material& m) {
  Pose pose = m.below(2) == 0 ? turn(m) : integer_pose(m);
  for (Vector3& c : pose.columns) {
    const double by = std::ldexp(1.0, static_cast<int>(m.entropy().within(1000)));
    const Vector3 scaled{c.x * by, c.y * by, c.z * by};
    if (std::isfinite(scaled.x) && std::isfinite(scaled.y) && std::isfinite(scaled.z)) c = scaled;
  }
  return pose;
}

inline Pose any_pose(Material& m) {
  const std::size_t kind = m.below(6);
  return kind == 0 ? extreme_pose(m) : kind == 1 ? turn(m) : kind == 2 ? identity_pose : integer_pose(m);
}
/// Often the same, or the same but for a shift: so meshes of one material meet.
inline Pose pose_like(Material& m, const Pose& other) {
  const std::size_t kind = m.below(4);
  if (kind == 0) return any_pose(m);
  Pose pose = other;
  if (kind == 1) pose.translation.x = m.number();
  if (kind == 2) std::swap(pose.columns[m.below(3)], pose.columns[m.below(3)]);
  return pose;
}

using RationalPoint = std::array<mpq_class, 3>;

inline RationalPoint image(const Point3& p, const Pose& pose) {
  const auto& [c, t] = pose;
  const auto part = [&](double a, double b, double d, double e) -> mpq_class {
    return mpq_class(a) * mpq_class(p.x) + mpq_class(b) * mpq_class(p.y) + mpq_class(d) * mpq_class(p.z) + mpq_class(e);
  };
  return {part(c[0].x, c[1].x, c[2].x, t.x), part(c[0].y, c[1].y, c[2].y, t.y), part(c[0].z, c[1].z, c[2].z, t.z)};
}

/// The posed point, where its coordinates are doubles.
inline std::optional<Point3> exact_point(const Point3& p, const Pose& pose) {
  const RationalPoint at = image(p, pose);
  std::array<double, 3> x{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (abs(at[k]) > mpq_class(std::numeric_limits<double>::max())) return {};
    x[k] = at[k].get_d();
    if (mpq_class(x[k]) != at[k]) return {};
  }
  return Point3{x[0], x[1], x[2]};
}

/// The posed mesh, where all coordinates are doubles.
inline std::optional<TriangleMesh> exact_mesh(const TriangleMesh& mesh, const Pose& pose) {
  TriangleMesh posed = mesh;
  for (Point3& p : posed.vertices) {
    const auto at = exact_point(p, pose);
    if (!at) return {};
    p = *at;
  }
  return posed;
}

inline Posed<Triangle3> posed_triangle(const TriangleMesh& mesh, std::size_t i, const Pose& pose) {
  const auto& [a, b, c] = mesh.triangles[i];
  return {{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}, pose};
}

}  // namespace plumb::poses
