// Which rigid poses are figures asked under?  Turns on the lattice and off it, of any length, and chains.
#pragma once

#include "plumb/query/body/posed.hpp"
#include "query/body/pair_moves.hpp"

namespace plumb::pair_cases {

/// One in space and one in the plane.
struct RigidCase {
  std::variant<RigidPose, RigidChain> space;
  std::variant<RigidPose2, RigidChain2> plane;

  [[nodiscard]] query::PoseView view(int dimension) const {
    const auto seen = [](const auto& by) { return query::PoseView(&by); };
    return dimension == 3 ? std::visit(seen, space) : std::visit(seen, plane);
  }
  [[nodiscard]] query::PosedView posed(const query::FigureView& v) const { return {v, view(v.dimension)}; }
};

inline RigidPose rigid_pose(Material& m, bool is_short) {
  const auto part = [&] {
    const double whole = static_cast<double>(m.below(1u << 26)) - 0x1p25;
    return is_short ? whole * 0x1p-25 : (whole + 0.1) * 0x1p-26;
  };
  RigidPose pose{{part(), part(), part(), part()}, {}};
  if (m.below(4) == 0) pose.turn = {1, static_cast<double>(m.below(2)), 0, static_cast<double>(m.below(2))};
  const auto step = [&] { return static_cast<double>(m.below(9)) - 4; };
  pose.translation = {step(), step() / 3, step() * 0.1};
  return pose;
}
inline RigidPose2 flat_of(const RigidPose& pose) {
  const bool is_none = pose.turn.w == 0 && pose.turn.z == 0;
  return {is_none ? Rotation2{} : Rotation2{pose.turn.w, pose.turn.z}, {pose.translation.x, pose.translation.y}};
}

/// Mostly turns whose matrices are doubles; else longer numbers, quaternions of extreme length, and chains of up to four.
inline RigidCase rigid_case(Material& m) {
  const auto kind = m.below(6);
  RigidPose pose = rigid_pose(m, kind < 3);
  if (kind == 4) {
    const double size = m.below(2) == 0 ? 0x1p400 : 0x1p-300;
    auto& [w, x, y, z] = pose.turn;
    w *= size, x *= size, y *= size, z *= size;
  }
  if (kind != 5) return {pose, flat_of(pose)};
  RigidChain chain;
  RigidChain2 flat;
  for (auto n = m.below(5); n > 0; --n) {
    chain.links.push_back(rigid_pose(m, n > 1));
    flat.links.push_back(flat_of(chain.links.back()));
  }
  return {std::move(chain), std::move(flat)};
}

}  // namespace plumb::pair_cases
