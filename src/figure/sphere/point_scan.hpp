// Extreme points: which points lie far from a center?  Passes of plain doubles over all points, with certain limits for
// what they say.
//
// Laws: what a pass computes is |cp|^2 times the square of a power of two, rounded; within() and rivals() turn it into
// certain statements, by the error that is part of its type.  Points are finite.
// Cost: a pass 1 to 2 ns a point, or what memory allows.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

#include "arith/twofold.hpp"
#include "certify/rounded.hpp"
#include "figure/basic/finite_parts.hpp"
#include "figure/sphere/block_reach.hpp"
#include "figure/sphere/rest_scan.hpp"
#include "figure/sphere/spanned_ball.hpp"
#include "plumb/arith/ball.hpp"
#include "plumb/arith/error_free.hpp"
#include "plumb/arith/interval.hpp"

namespace plumb::figure::sphere {

/// The extent of the points, for which there is at least one.  Throws NonFinite naming function and point.
template <class Point>
Extent<Point> extent(std::string_view function, std::span<const Point> points) {
  Extent<Point> e;
  if (!find_extent(points, e)) figure::require_finite_points(function, "points", points);
  return e;
}

inline Point2 middle_of(const Extent<Point2>& e) {
  return {std::midpoint(e.min.x, e.max.x), std::midpoint(e.min.y, e.max.y)};
}
inline Point3 middle_of(const Extent<Point3>& e) {
  return {std::midpoint(e.min.x, e.max.x), std::midpoint(e.min.y, e.max.y), std::midpoint(e.min.z, e.max.z)};
}

/// The largest half width; finite.
inline double half_width(const Extent<Point2>& e) {
  return std::max(e.max.x / 2 - e.min.x / 2, e.max.y / 2 - e.min.y / 2);
}
inline double half_width(const Extent<Point3>& e) {
  return std::max({e.max.x / 2 - e.min.x / 2, e.max.y / 2 - e.min.y / 2, e.max.z / 2 - e.min.z / 2});
}

/// A power of two that brings this width to the order of 1; 1 where doubles need no such help.
inline double scale_for(double width) {
  constexpr double least = 0x1p-300, greatest = 0x1p300;  // guesses: squares of what is between them are doubles
  if (width == 0 || (width > least && width < greatest)) return 1;
  return std::ldexp(1.0, std::clamp(-std::ilogb(width), -1021, 1022));
}

template <class Point>
class PointScan {
 public:
  static constexpr std::size_t block = 128;  // points that are looked at or left out at once: a guess of cost alone
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  PointScan(std::span<const Point> points, double scale)
      : points_(points), scale_(scale), most_((points.size() + block - 1) / block) {}

  [[nodiscard]] double scale() const { return scale_; }
  [[nodiscard]] std::size_t blocks() const { return most_.size(); }
  [[nodiscard]] double distance(const Point& c, std::size_t i) const {
    return square_of_distance(c, points_[i], scale_).value;
  }

  /// The largest distance from the center; remembers the largest of each block, and the center.
  double pass(const Point& c) {
    if (center_ == c) return all_;
    center_ = c, all_ = 0;
    for (std::size_t b = 0; b < most_.size(); ++b) {
      most_[b] = farthest_square(c, points_.subspan(b * block, end_of(b) - b * block), scale_);
      all_ = std::max(all_, most_[b]);
    }
    return all_;
  }

  /// Whoever is at this computed distance or nearer is certainly within `reach` of the center.
  [[nodiscard]] double within(double reach) const {
    if (!(reach > 0)) return -1;
    const Interval k = Interval(scale_) * Interval(reach);
    return Square::certainly_within(std::min((k * k).lower, std::numeric_limits<double>::max()));
  }

  /// Whoever is nearer than this computed distance is certainly nearer than someone at the distance `most`.
  [[nodiscard]] static double rivals(double most) {
    return most < infinity ? Square::certainly_within(Square{most}.lower()) : 0;
  }

  /// Calls visit(first, points) for every block with a point at this computed distance or farther, until that says false.
  template <class Visit>
  void blocks_from(double least, Visit visit) const {
    for (std::size_t b = 0; b < most_.size(); ++b) {
      const std::size_t first = b * block;
      if (most_[b] >= least && !visit(first, points_.subspan(first, end_of(b) - first))) return;
    }
  }

  /// The farthest point of each of the `count` farthest blocks that reach beyond `limit`, the very farthest first.
  void farthest(const Point& c, double limit, std::size_t count, std::vector<std::size_t>& into) const {
    std::vector<std::size_t> blocks;
    for (std::size_t b = 0; b < most_.size(); ++b) {
      if (most_[b] > limit) blocks.push_back(b);
    }
    const auto farther = [&](std::size_t a, std::size_t b) {
      return most_[a] > most_[b] || (most_[a] == most_[b] && a < b);
    };
    const std::size_t kept = std::min(count, blocks.size());
    std::ranges::partial_sort(blocks, blocks.begin() + static_cast<std::ptrdiff_t>(kept), farther);
    for (std::size_t k = 0; k < kept; ++k) {
      std::size_t i = blocks[k] * block;
      // Ends, for the block's largest distance is that of one of its points, computed alike from the same c.
      while (distance(c, i) != most_[blocks[k]]) ++i;
      into.push_back(i);
    }
  }

 private:
  using Square = decltype(square_of_distance(Point{}, Point{}, 1));

  [[nodiscard]] std::size_t end_of(std::size_t b) const { return std::min(points_.size(), (b + 1) * block); }

  std::span<const Point> points_;
  double scale_;
  std::optional<Point> center_;
  double all_ = 0;
  std::vector<double> most_;
};

/// The farthest of some points from a center: those that are not certainly nearer than another.
template <class Spanned>
class FarthestPoints {
 public:
  using Point = PointOf<Spanned>;

  explicit FarthestPoints(const Point& center) : center_(center), most_(around(center)) {}

  void reserve(std::size_t count) { farthest_.reserve(count); }
  /// Is it certainly farther than all before?
  bool take(const Point& p) {
    const Two square = square_to(p);
    const int s = (square_ - square).certain_sign();
    if (s > 0) return false;
    farthest_.push_back({p, square});
    if (s == 0 && farthest_.size() > 1) return false;
    square_ = square, most_.square = square.ball();
    return true;
  }
  /// Around the center, to the farthest as far as that is certain.
  [[nodiscard]] const FineBall<Spanned>& ball() const { return most_; }
  [[nodiscard]] const Point& center() const { return center_; }
  /// The distance of the farthest, rounded up once; infinite beyond all doubles.
  [[nodiscard]] double distance() const {
    double most = 0;
    for (const auto& [p, square] : farthest_) {
      if ((square_ - square).certain_sign() > 0) continue;
      std::optional<double> quick = root(square).ball().rounded(Rounding::up);
      if (!quick) quick = root(most_.square_of_distance(p)).rounded(Rounding::up);  // exact where digits are few
      most = std::max(most, quick ? *quick : rounded_root(Rounding::up, SquaredDistance<Point>{}, center_, p));
    }
    return most;
  }

 private:
  using Two = Twofold<false>;
  struct Far {
    Point point;
    Two square;
  };
  [[nodiscard]] Two square_to(const Point& p) const {
    const auto to = coordinates(p), from = coordinates(center_);
    const auto along = [&](std::size_t a) {
      const Two d = Two::difference(to[a], from[a]);
      return d * d;
    };
    if constexpr (dimension<Spanned> == 3) {
      return along(0) + along(1) + along(2);
    } else {
      return along(0) + along(1);
    }
  }
  static FineBall<Spanned> around(const Point& center) {
    const auto exactly = [](auto... x) { return FineBall<Spanned>{{Ball{x}...}, Ball{-1}}; };
    return std::apply(exactly, std::tuple_cat(coordinates(center)));
  }

  Point center_;
  FineBall<Spanned> most_;
  Two square_{0};  // that of most_
  std::vector<Far> farthest_;
};

/// The distance of the farthest point from the center, rounded up once; infinite beyond all doubles.
template <class Spanned, class Point>
double enclosing_radius(PointScan<Point>& scan, RestScan<Spanned>& rests, std::span<const Point> points,
                        const Point& center) {
  FarthestPoints<Spanned> farthest(center);
  std::vector<std::size_t> open;
  const double least = scan.rivals(scan.pass(center));
  scan.farthest(center, -1, 1, open);
  farthest.take(points[open[0]]);
  rests.aim(farthest.ball());
  scan.blocks_from(least, [&](std::size_t first, std::span<const Point>) {
    open.clear();
    rests.not_certainly_inside(first, open);
    for (const std::size_t i : open) {
      if (scan.distance(center, i) >= least && farthest.take(points[i])) rests.aim(farthest.ball());
    }
    return true;
  });
  return farthest.distance();
}

}  // namespace plumb::figure::sphere
