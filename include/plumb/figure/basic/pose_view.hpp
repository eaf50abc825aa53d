// Which pose is it?  One argument takes any of them: a Pose, a RigidPose or a RigidChain; of the plane likewise.
//
//   Aabb3 transform(const Aabb3& box, PoseView pose);       transform(box, RigidPose{turn, {1, 2, 3}})
//
// A PoseView is a pose of space, a PoseView2 one of the plane; AnyPoseView one of either, or none.  AnyPose keeps what that
// sees.
// Laws: it is the pose that it was made of, which must outlive it; nothing is copied and nothing rounded.
// Source: none.
// Cost: a branch.  Nothing is searched.
#pragma once

#include <variant>

#include "plumb/arith/pose.hpp"
#include "plumb/arith/rigid_pose.hpp"

namespace plumb {

template <class... Poses>
class ViewOfPose {
 public:
  template <class By>
  requires(std::same_as<By, Poses> || ...)  //
      ViewOfPose(const By& pose)
      : is_(&pose) {}  // NOLINT: stands for it
  /// f(pose).
  template <class F>
  decltype(auto) visit(F f) const {
    return std::visit([&f](const auto* pose) -> decltype(auto) { return f(*pose); }, is_);
  }

 private:
  std::variant<const Poses*...> is_;
};
using PoseView = ViewOfPose<Pose, RigidPose, RigidChain>;
using PoseView2 = ViewOfPose<Pose2, RigidPose2, RigidChain2>;

/// Where a figure stands: as it is said, or under a pose.
using AnyPose = std::variant<std::monostate, Pose2, Pose, RigidPose2, RigidPose, RigidChain2, RigidChain>;

/// A pose whose type the compiler need not know; what has none stands as it is.
struct AnyPoseView {
  std::variant<std::monostate, const Pose*, const Pose2*, const RigidPose*, const RigidPose2*, const RigidChain*,
               const RigidChain2*>
      by;

  AnyPoseView() = default;
  template <class By>
  requires(PoseOfSpace<By> || PoseOfPlane<By>)  //
      AnyPoseView(const By* pose) {
    if (pose != nullptr) by = pose;
  }
  template <std::same_as<AnyPose> Kept>  // not what would become one on the way, and be gone
  AnyPoseView(const Kept& pose) {        // NOLINT: stands for it
    std::visit(
        [this]<class By>(const By& is) {
          if constexpr (!std::is_same_v<By, std::monostate>) by = &is;
        },
        pose);
  }

  [[nodiscard]] bool stands() const { return by.index() == 0; }
  friend bool operator==(const AnyPoseView&, const AnyPoseView&) = default;  // the same pose, not one like it
};

}  // namespace plumb
