// Between which doubles does a posed box lie?  Rounded outward.
//
// Laws: (1) around(pose, box) contains matrix * p + translation of every p in the box.  A bound that no double can be is
// infinite.  (2) It grows with the box.
// Rounding keeps order, so what rounds to x is not below the double before x, nor above the one after it: each operation
// is followed by that step, whether it rounded or not; also where it overflows or underflows.  No lower bound is ever
// +infinity and no upper one -infinity, so that their sums are numbers.
// Source: RTCD 4.2.6 (Arvo 1990).
// Cost: 18 products and sums, some 50 ns.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "plumb/arith/error.hpp"
#include "plumb/space/bvh/posed_mesh.hpp"
#include "space/bvh/blocks.hpp"

namespace plumb::space {

/// The double before; -infinity stays.
inline double lowered(double x) {
  constexpr std::int64_t rest = std::numeric_limits<std::int64_t>::max();
  const auto flip = [](std::int64_t bits) { return bits ^ (bits >> 63 & rest); };
  const std::int64_t least = flip(std::bit_cast<std::int64_t>(-std::numeric_limits<double>::infinity()));
  const std::int64_t at = flip(std::bit_cast<std::int64_t>(x));
  return std::bit_cast<double>(flip(at - static_cast<std::int64_t>(at > least)));
}
inline double raised(double x) { return -lowered(-x); }

/// Along one axis: row . [min, max] + shift.
inline double least_along(const std::array<double, 3>& row, double shift, const Aabb3& box) {
  const auto part = [](double m, double low, double high) { return lowered(m * (m < 0 ? high : low)); };
  const double xy = lowered(part(row[0], box.min.x, box.max.x) + part(row[1], box.min.y, box.max.y));
  return lowered(lowered(xy + part(row[2], box.min.z, box.max.z)) + shift);
}

inline Aabb3 around(const Pose& pose, const Aabb3& box) {
  const auto& [c, t] = pose;
  const auto most_along = [&](const std::array<double, 3>& row, double shift) {
    return -least_along({-row[0], -row[1], -row[2]}, -shift, box);
  };
  const std::array<double, 3> x{c[0].x, c[1].x, c[2].x}, y{c[0].y, c[1].y, c[2].y}, z{c[0].z, c[1].z, c[2].z};
  return {{least_along(x, t.x, box), least_along(y, t.y, box), least_along(z, t.z, box)},
          {most_along(x, t.x), most_along(y, t.y), most_along(z, t.z)}};
}

inline Aabb3 merged(const Aabb3& a, const Aabb3& b) {
  return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y), std::min(a.min.z, b.min.z)},
          {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y), std::max(a.max.z, b.max.z)}};
}
inline Aabb3 around(const Posed<Triangle3>& t) {
  const auto of = [&](const Point3& p) { return around(t.pose, {p, p}); };
  return merged(merged(of(t.shape.a), of(t.shape.b)), of(t.shape.c));
}

/// Has it no infinite bound?
inline bool is_bounded(const Aabb3& box) {
  constexpr double most = std::numeric_limits<double>::max();
  return box.min.x >= -most && box.min.y >= -most && box.min.z >= -most && box.max.x <= most && box.max.y <= most &&
         box.max.z <= most;
}

inline Aabb3 around(const PosedMesh& mesh, const BoxNode& node) {
  return around(mesh.pose, mesh.bvh.tree.frame.outside(node.box()));
}

/// Of all nodes.
inline std::vector<Aabb3> posed_boxes(const PosedMesh& mesh, Execution execution) {
  const std::span<const BoxNode> nodes = mesh.bvh.tree.nodes.view();
  std::vector<Aabb3> boxes(nodes.size());
  for_blocks(execution, nodes.size(), 1 << 12, [&](std::size_t, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) boxes[i] = around(mesh, nodes[i]);
  });
  return boxes;
}

/// Throws NonFinite: "first_hit: mesh.pose.columns[0].x is nan, not a real number; give a finite double".
inline void require_pose(const char* function, const char* name, const Pose& pose) {
  const auto require = [&](const std::string& part, const Vector3& v) {
    for (const auto& [axis, x] : {std::pair{".x", v.x}, {".y", v.y}, {".z", v.z}}) {
      if (x - x == 0) continue;
      throw NonFinite(std::string(function) + ": " + name + ".pose" + part + axis + " is " +
                      (x > 0   ? "inf"
                       : x < 0 ? "-inf"
                               : "nan") +
                      ", not a real number; give a finite double");
    }
  };
  for (std::size_t i = 0; i < 3; ++i) require(".columns[" + std::to_string(i) + "]", pose.columns[i]);
  require(".translation", pose.translation);
}

}  // namespace plumb::space
