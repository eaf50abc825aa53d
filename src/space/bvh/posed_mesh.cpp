#include "plumb/space/bvh/posed_mesh.hpp"

#include "figure/basic/pose_numbers.hpp"
#include "plumb/figure/basic/sound.hpp"
#include "query/body/weighted_pose.hpp"

namespace plumb {
namespace {

MeshPose::Rows rows_of_numbers(const query::WeightedPose<Interval>& by) {
  const auto part = [&](const Interval& x) { return by.has_weight ? quotient(x, by.weight) : x; };
  const auto row = [&](std::size_t i) {
    return std::array{part(by.entry(i, 0)), part(by.entry(i, 1)), part(by.entry(i, 2)),
                      part(by.coordinate(by.translation, i))};
  };
  return {row(0), row(1), row(2)};
}

/// Of what is no pose, or one of the largest numbers.
MeshPose::Rows unknown() {
  const Interval any(-Interval::infinity, Interval::infinity);
  const std::array row{any, any, any, any};
  return {row, row, row};
}

}  // namespace

MeshPose::Rows MeshPose::rows_of(const RigidPose& pose) {
  if (!figure::is_sound(pose)) return unknown();
  Rows rows = rows_of_numbers(query::weighted_pose<Interval>(AnyPoseView(&pose)));
  const auto& [x, y, z] = pose.translation;
  rows[0][3] = Interval(x), rows[1][3] = Interval(y), rows[2][3] = Interval(z);
  return rows;
}
MeshPose::Rows MeshPose::rows_of(const RigidChain& pose) {
  if (!figure::is_sound(pose)) return unknown();
  return rows_of_numbers(query::weighted_pose<Interval>(AnyPoseView(&pose)));
}

}  // namespace plumb
