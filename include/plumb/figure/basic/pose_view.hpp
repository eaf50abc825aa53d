// Which pose is it?  One argument takes any of them: a Pose, a RigidPose or a RigidChain; of the plane likewise.
//
//   Aabb3 transform(const Aabb3& box, PoseView pose);       transform(box, RigidPose{turn, {1, 2, 3}})
//
// Laws: it is the pose that it was made of, which must outlive it; nothing is copied and nothing rounded.
// Source: none.
// Cost: a branch.  Nothing is searched.
#pragma once

#include <variant>

#include "plumb/arith/pose.hpp"
#include "plumb/arith/rigid_pose.hpp"

namespace plumb {

class PoseView {
 public:
  PoseView(const Pose& pose) : is_(&pose) {}        // NOLINT: stands for it
  PoseView(const RigidPose& pose) : is_(&pose) {}   // NOLINT
  PoseView(const RigidChain& pose) : is_(&pose) {}  // NOLINT
  /// f(pose).
  template <class F>
  decltype(auto) visit(F f) const {
    return std::visit([&f](const auto* pose) -> decltype(auto) { return f(*pose); }, is_);
  }

 private:
  std::variant<const Pose*, const RigidPose*, const RigidChain*> is_;
};

class PoseView2 {
 public:
  PoseView2(const Pose2& pose) : is_(&pose) {}        // NOLINT: stands for it
  PoseView2(const RigidPose2& pose) : is_(&pose) {}   // NOLINT
  PoseView2(const RigidChain2& pose) : is_(&pose) {}  // NOLINT
  /// f(pose).
  template <class F>
  decltype(auto) visit(F f) const {
    return std::visit([&f](const auto* pose) -> decltype(auto) { return f(*pose); }, is_);
  }

 private:
  std::variant<const Pose2*, const RigidPose2*, const RigidChain2*> is_;
};

}  // namespace plumb
