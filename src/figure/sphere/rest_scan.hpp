// Extreme points: who of many is not certainly inside a ball, asked again and again while the ball hardly moves?  What
// is left to exact signs of points that lie on its boundary up to ulps.
//
// What a square leaves beyond the squared distance from a base is computed to some hundred bits once a point, and
// rounded; for a ball whose center is near the base plain doubles tell the rest (figure/sphere/stays_inside.hpp).
// Laws: whoever is not named is strictly inside.
// Source: plumb/arith/ball.hpp; RTCD 13.7.
// Cost: some 10 ns a point the first time, then 1.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "figure/sphere/block_reach.hpp"
#include "figure/sphere/spanned_ball.hpp"

namespace plumb::figure::sphere {

template <class Spanned>
class RestScan {
 public:
  using Point = PointOf<Spanned>;
  using Place = decltype(coordinates(Point()));
  static constexpr std::size_t block = 128;

  RestScan(std::span<const Point> points, const Extent<Point>& extent) : points_(points), extent_(extent) {}

  /// From now on of this ball.
  void aim(const FineBall<Spanned>& ball);
  /// Appends who of the block that begins with point `first` is not certainly inside.
  void not_certainly_inside(std::size_t first, std::vector<std::size_t>& into);

 private:
  struct Rests {
    std::array<double, block> rest;  // square - |p - base|^2, rounded
    double off;                      // by no more than this
  };

  void move_base(const FineBall<Spanned>& ball);
  [[nodiscard]] const Rests& rests_of(std::size_t first);
  [[nodiscard]] std::span<const Point> block_from(std::size_t first) const {
    return points_.subspan(first, std::min(block, points_.size() - first));
  }

  std::span<const Point> points_;
  Extent<Point> extent_;
  Place base_{}, by_{};
  double square_ = 0, lead_ = 0;  // the latter without what the rests are off
  std::size_t named_ = 0;         // since the aim was taken
  std::vector<std::unique_ptr<Rests>> of_block_;
};

}  // namespace plumb::figure::sphere
