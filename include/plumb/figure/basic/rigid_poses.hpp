// Where do two rigid poses lead one after the other, which undoes one, and where is one part as seen from another?
//
//   const RigidChain seen = relative(camera, part);        // exactly, whatever the numbers: three links
//   const RigidPose kept = rounded_relative(camera, part); // one pose of doubles, rounded once
//   if (same_turn(p, q)) ...                               // decided of the numbers as they are
//
// A rotation is undone by its conjugate, exactly.  A pose that undoes another is exact as a chain of two links, and poses
// one after the other are exact as a chain; one link of doubles holds them sometimes, and exact_... tells whether.
// Laws: (1) rounded_... is the exact pose, each number of it rounded once to the nearest double, ties to even; still a
// rigid one.  The quaternion is the product of the quaternions, or its multiple by a power of two.  (2) exact_... is the
// same where no number had to be rounded, else nothing; the turn of two quaternions of the lattice always is exact
// (arith/rigid_pose.hpp).  (3) The product is first the inner turn, then the outer one.  (4) exact_pose and rounded_pose
// make a matrix of it, exact where doubles hold all its numbers: of quarter turns.
// NaN and infinity throw NonFinite, the quaternion zero InvalidShape, a number beyond the doubles BeyondDoubles; all by
// name.
// Source: RTCD 3.1.1, 3.2, 3.3; Hamilton's product.
// Cost: some 2 us a composition of two, 1 us a link more; twice that where pairs of doubles leave a choice.  Nothing
// is searched.
#pragma once

#include <optional>

#include "plumb/arith/rigid_pose.hpp"
#include "plumb/figure/basic/pose_view.hpp"

namespace plumb {

/// The conjugate.
constexpr Rotation inverse(const Rotation& turn) { return {turn.w, -turn.x, -turn.y, -turn.z}; }
constexpr Rotation2 inverse(const Rotation2& turn) { return {turn.w, -turn.z}; }

/// Translated back, then turned back.
RigidChain inverse(const RigidPose& pose);
RigidChain2 inverse(const RigidPose2& pose);
RigidChain inverse(const RigidChain& pose);
RigidChain2 inverse(const RigidChain2& pose);

/// What `of` is in the frame of `in`: its own pose undone by that of `in`.
RigidChain relative(const RigidPose& in, const RigidPose& of);
RigidChain2 relative(const RigidPose2& in, const RigidPose2& of);
RigidChain relative(const RigidChain& in, const RigidChain& of);
RigidChain2 relative(const RigidChain2& in, const RigidChain2& of);

/// One pose that is the chain.
RigidPose rounded_link(const RigidChain& chain);
RigidPose2 rounded_link(const RigidChain2& chain);
std::optional<RigidPose> exact_link(const RigidChain& chain);
std::optional<RigidPose2> exact_link(const RigidChain2& chain);

/// First `inner`, then `outer`.
Rotation rounded_composition(const Rotation& outer, const Rotation& inner);
Rotation2 rounded_composition(const Rotation2& outer, const Rotation2& inner);
std::optional<Rotation> exact_composition(const Rotation& outer, const Rotation& inner);
std::optional<Rotation2> exact_composition(const Rotation2& outer, const Rotation2& inner);
RigidPose rounded_composition(const RigidPose& outer, const RigidPose& inner);
RigidPose2 rounded_composition(const RigidPose2& outer, const RigidPose2& inner);
std::optional<RigidPose> exact_composition(const RigidPose& outer, const RigidPose& inner);
std::optional<RigidPose2> exact_composition(const RigidPose2& outer, const RigidPose2& inner);

RigidPose rounded_inverse(const RigidPose& pose);
RigidPose2 rounded_inverse(const RigidPose2& pose);
std::optional<RigidPose> exact_inverse(const RigidPose& pose);
std::optional<RigidPose2> exact_inverse(const RigidPose2& pose);

RigidPose rounded_relative(const RigidPose& in, const RigidPose& of);
RigidPose2 rounded_relative(const RigidPose2& in, const RigidPose2& of);

/// Do both stand for one turn, exactly?
bool same_turn(const Rotation& p, const Rotation& q);
bool same_turn(const Rotation2& p, const Rotation2& q);

/// As a matrix and a translation: no longer rigid where a number is rounded.
Pose rounded_pose(PoseView pose);
Pose2 rounded_pose(PoseView2 pose);
std::optional<Pose> exact_pose(PoseView pose);
std::optional<Pose2> exact_pose(PoseView2 pose);

}  // namespace plumb
