// Which turn is a quaternion, and which is one turn after another?  By name, each number exact and rounded once.
//
//   const Pose turned = *rounded_turn({1, 0, 0, 1});       // by a quarter about z: no root, no sine, exact
//   if (same_turn(p, q)) ...                               // decided of the numbers as they are
//
// A quaternion stands for the turn v -> q v q^-1 whatever its length: it need not be, and in doubles never quite is, a
// unit.  So the matrix of a turn has rational numbers, of which each is rounded once; a decision about turned shapes
// that must not be rounded takes the Posed figure of exact_turn, where doubles hold it.
// Laws: (1) each number is the exact one of the arguments, rounded once to the nearest double, ties to even; zero is
// never -0, but in what conjugate makes.  (2) Multiples of a quaternion, negative ones too, are the same turn and have
// the same matrix, bit for bit.  (3) The product p q is first the turn q, then p.  (4) The quaternion zero is no turn.
// NaN and infinity throw NonFinite, a number beyond the doubles BeyondDoubles; both by name.
// Source: RTCD 3.1.1, 3.3; Hamilton's product.
// Cost: some 30 ns a number; about 1 us where pairs of doubles leave a choice.
#pragma once

#include <optional>

#include "plumb/arith/pose.hpp"

namespace plumb {

/// w + x i + y j + z k.
struct Quaternion {
  double w, x, y, z;
  friend bool operator==(const Quaternion&, const Quaternion&) = default;
};

constexpr Quaternion conjugate(const Quaternion& q) { return {q.w, -q.x, -q.y, -q.z}; }

/// Hamilton's product p q.
Quaternion rounded_product(const Quaternion& p, const Quaternion& q);
/// Nothing where a number would have to be rounded.
std::optional<Quaternion> exact_product(const Quaternion& p, const Quaternion& q);

/// Infinite beyond all doubles.
double rounded_length(const Quaternion& q);

/// The pose of the turn about the origin.  Nothing for zero.
std::optional<Pose> rounded_turn(const Quaternion& q);
/// Nothing where a number of it would have to be rounded, as well.
std::optional<Pose> exact_turn(const Quaternion& q);

/// The turned vector, not by way of a rounded matrix.  Nothing for the quaternion zero.
std::optional<Vector3> rounded_turned(const Quaternion& q, const Vector3& v);

/// Do both stand for one turn, exactly?  Zero, which is none, is the same as itself only.
bool same_turn(const Quaternion& p, const Quaternion& q);

}  // namespace plumb
