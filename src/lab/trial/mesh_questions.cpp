#include "lab/trial/mesh_questions.hpp"

namespace plumb::lab::trial {

Pose pose_in(std::span<const double> q) {
  if (q[5] == 0) return identity_pose;
  const auto axis = [](const Vector3& v, double k) { return k == 0 ? v.x : k == 1 ? v.y : v.z; };
  Pose pose{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3& column = common_turn.columns[static_cast<std::size_t>(q[2 + i])];
    pose.columns[i] = {axis(column, q[2]), axis(column, q[3]), axis(column, q[4])};
  }
  return pose;
}

Symmetry mesh_axes_in_turn(std::size_t names, std::size_t points, bool posed) {
  Symmetry s{{}, 1};
  const auto add = [&s](std::size_t number) { s.from.push_back(static_cast<std::uint8_t>(number)); };
  for (std::size_t i = 0; i < names; ++i) add(i);
  for (std::size_t first = names; first < names + 3 + 3 * points; first += 3) {
    for (const std::size_t k : {1U, 2U, 0U}) add(first + k);
  }
  if (posed) add(names + 3);
  return s;
}

}  // namespace plumb::lab::trial
