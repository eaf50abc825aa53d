// Which rigid poses must be asked?  Quaternions of the lattice and beside it, quarter turns and Pythagorean ones, of
// huge and of tiny parts; and where are the images, in rational numbers?
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "figure/basic/rationals.hpp"
#include "plumb/arith/rigid_pose.hpp"
#include "plumb/degenerate.hpp"

namespace plumb::rigid_poses {

/// In the order of how simple they are: the simplest comes of an exhausted stream.
enum class TurnKind : std::uint8_t {
  quarter,       // about axes of space, by multiples of a quarter
  pythagorean,   // of small integers
  lattice,       // multiples of 2^-25, of length about 1
  long_lattice,  // of all lengths that the lattice has
  beside,        // of length about 1, each part a double of its own
  huge,          // any of these, times a large power of two
  tiny,          // or a small one: parts may be subnormal
  any            // parts of every coordinate class
};
inline constexpr std::uint64_t turn_kind_count = 8;

namespace detail {

inline std::array<double, 4> parts(TurnKind kind, Entropy& entropy) {
  std::array<double, 4> q{};
  const auto each = [&](auto make) {
    for (double& x : q) x = make();
  };
  const auto about_unit = [&] {
    each([&] { return static_cast<double>(entropy.within(1 << 20)); });
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    each([&, i = std::size_t{0}]() mutable { return length == 0 ? 0 : q[i++] / length; });
  };
  switch (kind) {
    case TurnKind::quarter:
      each([&] { return static_cast<double>(entropy.within(1)); });
      break;
    case TurnKind::pythagorean:
      each([&] { return static_cast<double>(entropy.within(9)); });
      break;
    case TurnKind::lattice:
      about_unit();
      for (double& x : q) x = std::nearbyint(x * 0x1p25) * 0x1p-25;
      break;
    case TurnKind::long_lattice:
      each([&] { return static_cast<double>(entropy.within(47453132)) * 0x1p-25; });  // four squares of it are below 8
      break;
    case TurnKind::beside:
      about_unit();
      break;
    case TurnKind::huge:
    case TurnKind::tiny: {
      q = parts(static_cast<TurnKind>(entropy.below(5)), entropy);
      const int by = static_cast<int>(entropy.below(kind == TurnKind::huge ? 1021 : 1074));
      for (double& x : q) x = std::ldexp(x, kind == TurnKind::huge ? by : -by);
      break;
    }
    default: {
      const auto of = static_cast<CoordinateClass>(entropy.below(coordinate_class_count));
      each([&] { return coordinate_of(of, entropy); });
    }
  }
  return q;
}

/// A coordinate for a translation, far below the largest doubles.
inline double place(Entropy& entropy) {
  switch (entropy.below(4)) {
    case 0:
      return static_cast<double>(entropy.within(8));
    case 1:
      return static_cast<double>(entropy.within(1 << 30)) * 0x1p-20;
    case 2:
      return static_cast<double>(entropy.within(1LL << 52)) * 0x1p-48;
    default:
      return std::ldexp(static_cast<double>(entropy.within(1LL << 52)), static_cast<int>(entropy.within(100)));
  }
}

}  // namespace detail

/// Never zero: where all parts are, the identity.
inline Rotation turn(TurnKind kind, Entropy& entropy) {
  const auto [w, x, y, z] = detail::parts(kind, entropy);
  return w == 0 && x == 0 && y == 0 && z == 0 ? Rotation{} : Rotation{w, x, y, z};
}
inline Rotation2 turn2(TurnKind kind, Entropy& entropy) {
  const auto [w, x, y, z] = detail::parts(kind, entropy);
  return w == 0 && z == 0 ? Rotation2{} : Rotation2{w, z};
}
inline Rotation turn(Entropy& entropy) { return turn(static_cast<TurnKind>(entropy.below(turn_kind_count)), entropy); }
inline Rotation2 turn2(Entropy& entropy) {
  return turn2(static_cast<TurnKind>(entropy.below(turn_kind_count)), entropy);
}

inline RigidPose pose(TurnKind kind, Entropy& entropy) {
  const Rotation by = turn(kind, entropy);
  const double x = detail::place(entropy), y = detail::place(entropy), z = detail::place(entropy);
  return {by, {x, y, z}};
}
inline RigidPose2 pose2(TurnKind kind, Entropy& entropy) {
  const Rotation2 by = turn2(kind, entropy);
  const double x = detail::place(entropy), y = detail::place(entropy);
  return {by, {x, y}};
}
inline RigidPose pose(Entropy& entropy) { return pose(static_cast<TurnKind>(entropy.below(turn_kind_count)), entropy); }
inline RigidPose2 pose2(Entropy& entropy) {
  return pose2(static_cast<TurnKind>(entropy.below(turn_kind_count)), entropy);
}

/// A chain has up to four links, perhaps none.
inline RigidChain chain(Entropy& entropy) {
  RigidChain made;
  for (std::uint64_t left = entropy.below(5); left > 0; --left) made.links.push_back(pose(entropy));
  return made;
}
inline RigidChain2 chain2(Entropy& entropy) {
  RigidChain2 made;
  for (std::uint64_t left = entropy.below(5); left > 0; --left) made.links.push_back(pose2(entropy));
  return made;
}

/// q v q^-1 by Hamilton's table, not by a matrix.
inline rationals::Vector turned(const Rotation& q, const rationals::Vector& v) {
  using Four = std::array<mpq_class, 4>;
  const auto product = [](const Four& a, const Four& b) {
    constexpr std::array<std::array<int, 4>, 4> unit{{{1, 2, 3, 4}, {2, -1, 4, -3}, {3, -4, -1, 2}, {4, 3, -2, -1}}};
    Four made{};
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        mpq_class& to = made[static_cast<std::size_t>(std::abs(unit[i][j]) - 1)];
        if (unit[i][j] > 0) {
          to += a[i] * b[j];
        } else {
          to -= a[i] * b[j];
        }
      }
    }
    return made;
  };
  const Four of{q.w, q.x, q.y, q.z}, back{q.w, -q.x, -q.y, -q.z};
  const mpq_class square = product(of, back)[0];
  const Four made = product(product(of, {0, v[0], v[1], v.size() == 3 ? v[2] : mpq_class()}), back);
  rationals::Vector image{mpq_class(made[1] / square), mpq_class(made[2] / square)};
  if (v.size() == 3) image.push_back(made[3] / square);
  return image;
}
inline rationals::Vector turned(const Rotation2& q, const rationals::Vector& v) {
  return turned(Rotation{q.w, 0, 0, q.z}, v);
}

/// Where a point is under the pose; under a chain the last link comes first.
template <class By>
rationals::Vector image(const By& pose, const rationals::Vector& p) {
  using rationals::operator+;
  if constexpr (requires { pose.links; }) {
    rationals::Vector at = p;
    for (std::size_t i = pose.links.size(); i-- > 0;) at = image(pose.links[i], at);
    return at;
  } else {
    return turned(pose.turn, p) + rationals::exact(pose.translation);
  }
}

}  // namespace plumb::rigid_poses
