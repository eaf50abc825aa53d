// Which rotation is nearest to this matrix, which turns about this axis by this angle, and how far off is it?
//
//   const auto [turn, off] = rotation({0, 0, 1}, 0.5);       // by half a radian about z, but for off, some 2^-25
//   const auto elbow = nearest_rotation(pose);               // of a matrix of rounded cosines; nothing of a mirror
//   Posed{ball, RigidPose{elbow->turn, pose.translation}}    // a ball, exactly
//
// What is made is a quaternion whose parts are multiples of 2^-25, so that its matrix is one of doubles, exactly
// (exact_matrix of arith/rigid_pose.hpp), and questions are quick.
// Laws: (1) off is certainly not less than how far the made turn is from what was asked: the angle of the turn between
// both, in radians; of nearest_rotation the root of the sum of squares by which the numbers of the matrices differ, so
// that no unit vector's image is farther off, and that is at least the angle where the matrix is a rotation.  It is below
// 2^-23 where a turn was asked.  (2) What the lattice holds is found exactly, and off is zero then: every multiple of a
// quaternion of the lattice and every multiple of a matrix of one.  A quaternion of the lattice stays as it is.
// (3) Nothing is made of a matrix whose determinant is not positive: a mirror or what flattens has no nearest rotation,
// or several.  (4) Angles are the numbers they are, radians, however large; nothing is taken modulo a rounded pi.
// NaN and infinity throw NonFinite, the axis zero and the quaternion zero InvalidShape; all by name.
// Source: RTCD 3.1.1; Kabsch 1976 and Horn 1987 for the guess.
// Cost: an angle below 64 some 2 us, larger ones up to some milliseconds; a matrix some 2 us, a multiple of a rotation
// some 5 us.  Nothing is searched.
#pragma once

#include <optional>

#include "plumb/arith/pose.hpp"
#include "plumb/arith/rigid_pose.hpp"

namespace plumb {

/// A turn of the lattice, and how far it is from what was asked, certainly not less.
struct NearRotation {
  Rotation turn;
  double off;
};
struct NearRotation2 {
  Rotation2 turn;
  double off;
};

/// Turns by the angle in radians about the axis, whose length is any, counterclockwise as seen from its end.
NearRotation rotation(const Vector3& axis, double angle);
/// Turns counterclockwise.
NearRotation2 rotation(double angle);

/// The rotation nearest to the matrix of the pose; its translation is not looked at.
std::optional<NearRotation> nearest_rotation(const Pose& pose);
std::optional<NearRotation2> nearest_rotation(const Pose2& pose);

/// The turn of the lattice nearest to another.
NearRotation on_turn_lattice(const Rotation& turn);
NearRotation2 on_turn_lattice(const Rotation2& turn);

}  // namespace plumb
