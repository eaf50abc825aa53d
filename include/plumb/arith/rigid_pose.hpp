// Where is a shape that was moved without changing any length?  A turn by a quaternion and a translation.
//
//   Posed{ball, RigidPose{{1, 0, 0, 1}, {2, 0, 0}}}     by a quarter about z, then by 2 along x: still a ball
//   Posed{ball, RigidChain{{shoulder, elbow, wrist}}}   the wrist as the elbow carries it, as the shoulder carries that
//
// A matrix of rounded cosines is never orthogonal.  A quaternion of doubles of any length but zero is a rotation as it
// is: its matrix is one of products of its numbers over the sum of their squares, exactly orthogonal.
// Laws: (1) a pose is what its numbers say; nothing is rounded and nothing normalized, and multiples of a quaternion,
// negative ones too, are the same turn.  (2) No distance changes under a rigid pose.  (3) The quaternion zero is no
// turn: whoever is asked throws InvalidShape.  (4) A chain is its last link first: the image of p under links[0] of the
// image under links[1] and so on; without links it is the identity.
// Source: RTCD 3.1.1, 3.2; Hamilton's product.
// Cost: none; exact_matrix some 5 ns.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <optional>
#include <vector>

#include "plumb/arith/pose.hpp"

namespace plumb {

/// The turn v -> q v q^-1 of the quaternion q = w + x i + y j + z k.
struct Rotation {
  double w = 1, x = 0, y = 0, z = 0;
  friend bool operator==(const Rotation&, const Rotation&) = default;
};
/// The same of the plane, q = w + z k: by twice the angle of the vector (w, z).
struct Rotation2 {
  double w = 1, z = 0;
  friend bool operator==(const Rotation2&, const Rotation2&) = default;
};

/// First turned about the origin, then translated.
struct RigidPose {
  Rotation turn;
  Vector3 translation{0, 0, 0};
  friend bool operator==(const RigidPose&, const RigidPose&) = default;
};
struct RigidPose2 {
  Rotation2 turn;
  Vector2 translation{0, 0};
  friend bool operator==(const RigidPose2&, const RigidPose2&) = default;
};

/// One pose after another, the last link nearest to the shape.
struct RigidChain {
  std::vector<RigidPose> links;
  friend bool operator==(const RigidChain&, const RigidChain&) = default;
};
struct RigidChain2 {
  std::vector<RigidPose2> links;
  friend bool operator==(const RigidChain2&, const RigidChain2&) = default;
};

template <class By>
concept PoseOfSpace = std::same_as<By, Pose> || std::same_as<By, RigidPose> || std::same_as<By, RigidChain>;
template <class By>
concept PoseOfPlane = std::same_as<By, Pose2> || std::same_as<By, RigidPose2> || std::same_as<By, RigidChain2>;

/// The matrix of a turn times its weight, the square of the quaternion's length: all of them doubles, not rounded.
struct TurnMatrix {
  std::array<Vector3, 3> columns;
  double weight;
};
struct TurnMatrix2 {
  std::array<Vector2, 2> columns;
  double weight;
};

namespace arith {

/// Whole multiples of 2^-25 of which the sum of squares is below 8: sums of their products are whole multiples of 2^-50
/// below 2^3, which are doubles.  A sum of 8 may be one that was rounded down to it.
constexpr bool is_on_turn_lattice(double w, double x, double y, double z) {
  const auto is_whole = [](double a) {
    const double k = a * 0x1p25;
    return k >= -0x1p27 && k <= 0x1p27 && k == static_cast<double>(static_cast<std::int64_t>(k));
  };
  return is_whole(w) && is_whole(x) && is_whole(y) && is_whole(z) && w * w + x * x + y * y + z * z < 8;
}

/// The multiple of q by a power of two that is on the lattice, and the same turn: q itself where it is.
constexpr std::optional<Rotation> multiple_on_turn_lattice(const Rotation& q) {
  if (is_on_turn_lattice(q.w, q.x, q.y, q.z)) return q;
  double greatest = 0;
  for (const double a : {q.w, q.x, q.y, q.z}) greatest = a > greatest ? a : (-a > greatest ? -a : greatest);
  if (!(greatest >= 0x1p-1000 && greatest <= 0x1p1000)) return {};
  // The greatest part comes into [2, 4), where the least are soonest whole; a fourth of it is short for certain.
  const std::uint64_t exponent = std::bit_cast<std::uint64_t>(greatest) >> 52;
  double scale = std::bit_cast<double>((std::uint64_t{2047} - exponent) << 52);
  for (int i = 0; i < 3; ++i, scale /= 2) {
    const Rotation scaled{q.w * scale, q.x * scale, q.y * scale, q.z * scale};
    if (is_on_turn_lattice(scaled.w, scaled.x, scaled.y, scaled.z)) return scaled;
  }
  return {};
}

}  // namespace arith

/// The matrix of q or of its multiple by a power of two.  Nothing where a number of it would have to be rounded, and for
/// zero.  Always there for multiples of 2^-25 of a length below the root of 8, as nearest_rotation makes them
/// (figure/basic/rotation.hpp), and for four integers of 25 bits.
constexpr std::optional<TurnMatrix> exact_matrix(const Rotation& q) {
  const auto on_lattice = arith::multiple_on_turn_lattice(q);
  if (!on_lattice) return {};
  const auto [w, x, y, z] = *on_lattice;
  const double ww = w * w, xx = x * x, yy = y * y, zz = z * z, weight = ww + xx + yy + zz;
  if (weight == 0) return {};
  const double xy = 2 * x * y, xz = 2 * x * z, yz = 2 * y * z, wx = 2 * w * x, wy = 2 * w * y, wz = 2 * w * z;
  return TurnMatrix{{{{ww + xx - yy - zz, xy + wz, xz - wy},
                      {xy - wz, ww - xx + yy - zz, yz + wx},
                      {xz + wy, yz - wx, ww - xx - yy + zz}}},
                    weight};
}
constexpr std::optional<TurnMatrix2> exact_matrix(const Rotation2& q) {
  const auto on_lattice = arith::multiple_on_turn_lattice({q.w, 0, 0, q.z});
  if (!on_lattice) return {};
  const auto [w, x, y, z] = *on_lattice;
  const double ww = w * w, zz = z * z, wz = 2 * w * z;
  if (ww + zz == 0) return {};
  return TurnMatrix2{{{{ww - zz, wz}, {-wz, ww - zz}}}, ww + zz};
}

}  // namespace plumb
