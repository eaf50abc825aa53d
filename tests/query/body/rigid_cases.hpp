// Which rigid poses are figures asked under?  Turns on the lattice and off it, of any length, and chains.
#pragma once

#include "figure/basic/rigid_poses.hpp"
#include "plumb/query/body/posed.hpp"
#include "query/body/pair_moves.hpp"

namespace plumb::pair_cases {

/// One in space and one in the plane.
struct RigidCase {
  std::variant<RigidPose, RigidChain> space;
  std::variant<RigidPose2, RigidChain2> plane;

  [[nodiscard]] AnyPoseView view(int dimension) const {
    const auto seen = [](const auto& by) { return AnyPoseView(&by); };
    return dimension == 3 ? std::visit(seen, space) : std::visit(seen, plane);
  }
  [[nodiscard]] query::PosedView posed(const query::FigureView& v) const { return {v, view(v.dimension)}; }
};

/// A turn of figure/basic/rigid_poses.hpp, more often than not one whose matrix is of doubles, and a short way.
inline RigidPose rigid_pose(Material& m) {
  using rigid_poses::TurnKind;
  const auto kind = static_cast<TurnKind>(m.below(m.below(8) == 0 ? rigid_poses::turn_kind_count : 5));
  const auto step = [&] { return static_cast<double>(m.below(9)) - 4; };
  const Rotation turn = rigid_poses::turn(kind, m.entropy());
  const double x = step(), y = step() / 3, z = step() * 0.1;
  return {turn, {x, y, z}};
}
inline RigidPose2 flat_of(const RigidPose& pose) {
  const bool is_none = pose.turn.w == 0 && pose.turn.z == 0;
  return {is_none ? Rotation2{} : Rotation2{pose.turn.w, pose.turn.z}, {pose.translation.x, pose.translation.y}};
}

/// One pose, or a chain of up to four.
inline RigidCase rigid_case(Material& m) {
  if (m.below(6) != 0) {
    const RigidPose pose = rigid_pose(m);
    return {pose, flat_of(pose)};
  }
  RigidChain chain;
  RigidChain2 flat;
  for (auto n = m.below(5); n > 0; --n) {
    chain.links.push_back(rigid_pose(m));
    flat.links.push_back(flat_of(chain.links.back()));
  }
  return {std::move(chain), std::move(flat)};
}

}  // namespace plumb::pair_cases
