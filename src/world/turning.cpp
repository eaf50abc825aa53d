#include "world/turning.hpp"

#include <algorithm>
#include <cmath>

#include "plumb/query/time_of_impact/moving_distance.hpp"
#include "world/grown_box.hpp"
#include "world/state.hpp"

namespace plumb::world {
namespace {

std::array<double, 4> parts_of(const Rotation& r) { return {r.w, r.x, r.y, r.z}; }

Interval square_of(const Interval& x) {
  const double most = std::max(x.upper, -x.lower), least = std::max({x.lower, -x.upper, 0.0});
  return Interval{least, most} * Interval{least, most};
}

/// How much longer than another length?  Infinitely, where the other may be zero.
double times_at_most(const Interval& length, const Interval& other) {
  return other.lower > 0 ? quotient(length, other).upper : Interval::infinity;
}

double reach_of(const Aabb3& b) {
  const auto far = [](double low, double high) { return Interval(std::max(std::fabs(low), std::fabs(high))); };
  return query::length_at_most(far(b.min.x, b.max.x), far(b.min.y, b.max.y), far(b.min.z, b.max.z));
}

Interval between(double from, double to, const Interval& time) {
  return Interval(from) + time * (Interval(to) - Interval(from));
}

Aabb3 common_to(const Aabb3& a, const Aabb3& b) {
  return {{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y), std::max(a.min.z, b.min.z)},
          {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y), std::min(a.max.z, b.max.z)}};
}

Aabb3 around(const Vector3& p) { return {{p.x, p.y, p.z}, {p.x, p.y, p.z}}; }

}  // namespace

Turning::Turning(const RigidPose& from, const RigidPose& to, const Aabb3& body)
    : from_(from), to_(to), reach_(reach_of(body)), wedge_(0.0) {
  const auto p = parts_of(from.turn), q = parts_of(to.turn);
  Interval sum(0.0);
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) {
      sum = sum + square_of(Interval(p[i]) * Interval(q[j]) - Interval(p[j]) * Interval(q[i]));
    }
  }
  wedge_ = root(sum);
  const auto way = [](double a, double b) { return Interval(b) - Interval(a); };
  translation_ =
      query::length_at_most(way(from.translation.x, to.translation.x), way(from.translation.y, to.translation.y),
                            way(from.translation.z, to.translation.z));
}

Turning::Quaternion Turning::turn_at(const Interval& time) const {
  const auto p = parts_of(from_.turn), q = parts_of(to_.turn);
  return {between(p[0], q[0], time), between(p[1], q[1], time), between(p[2], q[2], time), between(p[3], q[3], time)};
}

NearbyPose Turning::at(double t) const {
  if (t == 0) return {from_, 0};
  if (t == 1) return {to_, 0};
  const Quaternion q = turn_at(Interval(t));
  const Interval length = root(square_of(q[0]) + square_of(q[1]) + square_of(q[2]) + square_of(q[3]));
  if (!(length.lower > 0)) return {from_, Interval::infinity};  // it may be no turn
  query::NearbyPlaces near_turn, near_rest, near_translation;
  const Point3 vector = near_turn(q[1], q[2], q[3]);
  const double w = near_rest(q[0], Interval(0.0), Interval(0.0)).x;
  const auto along = [&](double a, double b) { return between(a, b, Interval(t)); };
  const Point3 to =
      near_translation(along(from_.translation.x, to_.translation.x), along(from_.translation.y, to_.translation.y),
                       along(from_.translation.z, to_.translation.z));
  NearbyPose near{{{w, vector.x, vector.y, vector.z}, {to.x, to.y, to.z}}, near_translation.off()};
  const Interval off_turn = Interval(near_turn.off()) + Interval(near_rest.off());
  if (!(off_turn.upper > 0)) return near;
  // On the straight way from one quaternion to the other none is shorter than that.
  const Interval least = length - off_turn;
  const Interval turned = Interval(2.0) * Interval(times_at_most(off_turn, least)) * Interval(reach_);
  near.off = (Interval(near.off) + turned).upper;
  return near;
}

double Turning::speed_between(double from, double to) const {
  const Quaternion q = turn_at(Interval{from, to});
  const Interval square = square_of(q[0]) + square_of(q[1]) + square_of(q[2]) + square_of(q[3]);
  if (!(wedge_.upper > 0)) return square.lower > 0 ? translation_ : Interval::infinity;
  const Interval turn = Interval(2.0) * Interval(times_at_most(wedge_, square));
  return (turn * Interval(reach_) + Interval(translation_)).upper;
}

Aabb3 Turning::way(const Aabb3& start) const {
  const Aabb3 centers = joined(around(from_.translation), around(to_.translation));
  const double speed = speed_between(0, 1);
  return common_to(grown(centers, reach_), grown(start, speed));
}

}  // namespace plumb::world
