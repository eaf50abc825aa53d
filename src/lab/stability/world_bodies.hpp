// Which bodies does a laboratory's world hold, and who tells which of them meet?
//
// Laws: (1) all bodies of a world are handed over at once, as broad and narrow phases of libraries take them; (2) a pair is
// told by its numbers, the lower one first, once.
// Source: RTCD 2.4.1.
// Cost: none.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "plumb/arith/rigid_pose.hpp"

namespace plumb::lab::stability {

/// The hull of eight corners under a rigid pose.
struct WorldBody {
  std::array<Point3, 8> corners;
  std::optional<Vector3> half;  // of a box about the origin, whose corners these are
  RigidPose pose;
};

using BodyPairs = std::set<std::array<std::uint32_t, 2>>;

/// A library's collision world; which bodies meet, as it says.
struct WorldRival {
  std::string name;
  std::function<BodyPairs(std::span<const WorldBody> bodies)> ask;
};

}  // namespace plumb::lab::stability
