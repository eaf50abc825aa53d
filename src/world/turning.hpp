// Where is a body that turns from one rigid pose to another, at a time, and how fast can its points be?
//
// At time t its quaternion is (1 - t) times the first plus t times the last, of any length, and so is its translation.
// Laws: (1) the body at time t is no farther than `off` from where `pose` puts it; at times 0 and 1 off is zero.  (2) No
// point of it is faster than speed_between says between two times; where the quaternion may be zero this is infinite.
// (3) way() holds all places of all times.
// The turn's speed is twice that of the unit quaternion, whose wedge with its own change does not depend on time.
// Source: RTCD 5.5.1; Hamilton's product.
// Cost: some tens of interval operations.
#pragma once

#include <array>

#include "plumb/arith/interval.hpp"
#include "plumb/arith/rigid_pose.hpp"
#include "plumb/figure/basic/box.hpp"

namespace plumb::world {

struct NearbyPose {
  RigidPose pose;
  double off;
};

class Turning {
 public:
  /// `body` is the box of the body where no pose moves it.
  Turning(const RigidPose& from, const RigidPose& to, const Aabb3& body);

  [[nodiscard]] NearbyPose at(double t) const;
  [[nodiscard]] double speed_between(double from, double to) const;
  /// `start` holds the body at time 0.
  [[nodiscard]] Aabb3 way(const Aabb3& start) const;

 private:
  using Quaternion = std::array<Interval, 4>;
  [[nodiscard]] Quaternion turn_at(const Interval& time) const;

  RigidPose from_, to_;
  double reach_;        // of a point from the center of the turn
  Interval wedge_;      // of the quaternion and its change
  double translation_;  // how fast it changes
};

}  // namespace plumb::world
