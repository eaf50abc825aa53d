// Time of impact: when exactly is a root of the coplanarity cubic, and do they meet then?  Pairs of doubles, where
// doubles do not tell.
//
// Laws: (1) the root's ball holds the one root that the cubic has between two times, given that its slope there is
// nowhere smaller than told.  (2) Crossings are certain, or unknown.
// The root is off the end of a Newton step by no more than the cubic there over the least slope (mean value theorem).
// Source: RTCD 5.5; Ziv 1991 (arith/ball.hpp).
// Cost: below a microsecond for the root, and for the crossing.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "plumb/arith/ball.hpp"
#include "plumb/arith/interval.hpp"
#include "plumb/arith/point.hpp"
#include "query/time_of_impact/feature_pairs.hpp"

namespace plumb::query::moving {

/// Where the figures' projections along an axis stay apart, cross strictly, or cannot be told.
enum class Crossing : unsigned char { apart, across, unknown };

/// No less than the size of what the ball holds.
inline double most_of(const Ball& x) {
  return Interval::sum_up(Interval::sum_up(Ball::size(x.high), Ball::size(x.low)), x.radius);
}

/// Where a cubic has one root: its slope is at least `least_slope` in size, and about `slope` at the guess.
struct Bracket {
  double from, to, guess, slope, least_slope;
};

class ContactAtRoot {
 public:
  ContactAtRoot(MovingKind kind, std::span<const Point3, 4> at_0, std::span<const Point3, 4> at_1);

  [[nodiscard]] std::optional<Ball> root(const Bracket& bracket) const;
  /// At a time of the ball, for coordinates other than those of the axis (0, 1, 2).
  [[nodiscard]] Crossing crossing(const Ball& time, std::size_t axis) const;

 private:
  struct Linear {
    std::array<Ball, 3> at_0, at_1;
  };
  [[nodiscard]] Ball cubic(const Ball& time) const;
  [[nodiscard]] static std::array<Ball, 3> product(const Linear& a, const Linear& b, std::size_t axis);

  MovingKind kind_;
  std::array<Linear, 4> differences_;
  std::array<Ball, 4> cubic_;  // Bernstein coefficients times binomials
};

}  // namespace plumb::query::moving
