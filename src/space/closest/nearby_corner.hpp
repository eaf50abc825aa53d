// An exact point of which a double is known, how far off that is at most, and what is nearest to it.
//
// Sums and differences are rounded outward (plumb/arith/interval.hpp); of 0 they are exact.
#pragma once

#include <cmath>

#include "plumb/query/time_of_impact/moving_distance.hpp"

namespace plumb::space {

struct NearbyCorner {
  Point3 at;
  double off;             // no less than the distance of the exact point
  std::uint32_t nearest;  // a triangle's number
  double distance;        // of the double from it, rounded
};

inline double sum_above(double x, double y) { return y == 0 ? x : (Interval(x) + Interval(y)).upper; }
inline double difference_below(double x, double y) { return y == 0 ? x : (Interval(x) - Interval(y)).lower; }

/// The exact point a part of the way from one to the other, 0 <= part <= 1; what is nearest is left open.
inline NearbyCorner corner_between(const NearbyCorner& p, const NearbyCorner& q, double part) {
  const Interval of_q(part), of_p = Interval(1) - of_q;
  const auto mean = [&](double x, double y) { return x == y ? Interval(x) : Interval(x) * of_p + Interval(y) * of_q; };
  query::NearbyPlaces near;
  const Point3 at = near(mean(p.at.x, q.at.x), mean(p.at.y, q.at.y), mean(p.at.z, q.at.z));
  return {at, sum_above(near.off(), std::fmax(p.off, q.off)), 0, 0};
}

}  // namespace plumb::space
