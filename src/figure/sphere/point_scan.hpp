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

#include "certify/rounded.hpp"
#include "figure/basic/finite_parts.hpp"
#include "figure/sphere/fine_scan.hpp"
#include "figure/sphere/spanned_ball.hpp"
#include "plumb/arith/ball.hpp"
#include "plumb/arith/error_free.hpp"
#include "plumb/arith/interval.hpp"
#include "plumb/arith/square_sum.hpp"

namespace plumb::figure::sphere {

template <class Point>
struct Extent {
  Point min, max;
};

/// The extent of the points, for which there is at least one.  Throws NonFinite naming function and point.
template <class Point>
Extent<Point> extent(std::string_view function, std::span<const Point> points) {
  Extent<Point> e{points[0], points[0]};
  double zero = 0;
  const auto take = [&](double Point::*axis) {
    double least = points[0].*axis, most = least, not_real = 0;
    for (const Point& p : points) {
      const double x = p.*axis;
      least = x < least ? x : least;
      most = x > most ? x : most;
      not_real += x - x;
    }
    e.min.*axis = least, e.max.*axis = most, zero += not_real;
  };
  take(&Point::x), take(&Point::y);
  if constexpr (requires { &Point::z; }) take(&Point::z);
  if (zero != 0) figure::require_finite_points(function, "points", points);
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

/// A power of two that brings this width to the order of 1; 1 where doubles need no such help, a guess.
inline double scale_for(double width) {
  if (width == 0 || (width > 0x1p-300 && width < 0x1p300)) return 1;
  return std::ldexp(1.0, std::clamp(-std::ilogb(width), -1021, 1022));
}

/// |cp|^2 times the square of a power of two.
template <bool scaled, class Point>
auto square_of_distance(const Point& c, const Point& p, double power) {
  const auto square = [power](double to, double from) {
    const auto d = arith::squares::difference(to, from);
    return squared(scaled ? arith::squares::scaled(d, power) : d);
  };
  if constexpr (std::is_same_v<Point, Point3>) {
    return square(p.x, c.x) + square(p.y, c.y) + square(p.z, c.z);
  } else {
    return square(p.x, c.x) + square(p.y, c.y);
  }
}

template <class Point>
class PointScan {
 public:
  static constexpr std::size_t block = 128;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  PointScan(std::span<const Point> points, double scale)
      : points_(points), scale_(scale), most_((points.size() + block - 1) / block) {}

  [[nodiscard]] double distance(const Point& c, std::size_t i) const {
    return scale_ == 1 ? plain<false>(c, points_[i]) : plain<true>(c, points_[i]);
  }

  /// The largest distance from the center; remembers the largest of each block.
  double pass(const Point& c) { return scale_ == 1 ? pass<false>(c) : pass<true>(c); }

  /// Whoever is at this computed distance or nearer is certainly within `reach` of the center.
  [[nodiscard]] double within(double reach) const {
    if (!(reach > 0)) return -1;
    const Interval k = Interval(scale_) * Interval(reach);
    return Square::certainly_within(std::min((k * k).lower, std::numeric_limits<double>::max()));
  }

  /// Whoever is nearer than this computed distance is certainly nearer than someone at the distance `most`.
  [[nodiscard]] double rivals(double most) const {
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
  using Square = decltype(square_of_distance<true>(Point{}, Point{}, 1));

  template <bool scaled>
  [[nodiscard]] double plain(const Point& c, const Point& p) const {
    return square_of_distance<scaled>(c, p, scale_).value;
  }

  [[nodiscard]] std::size_t end_of(std::size_t b) const { return std::min(points_.size(), (b + 1) * block); }

  template <bool scaled>
  double pass(const Point& c) {
    double all = 0;
    for (std::size_t b = 0; b < most_.size(); ++b) {
      std::size_t i = b * block;
      const std::size_t end = end_of(b);
      double m0 = 0, m1 = 0, m2 = 0, m3 = 0;
      for (; i + 4 <= end; i += 4) {
        const double s0 = plain<scaled>(c, points_[i]), s1 = plain<scaled>(c, points_[i + 1]);
        const double s2 = plain<scaled>(c, points_[i + 2]), s3 = plain<scaled>(c, points_[i + 3]);
        m0 = s0 > m0 ? s0 : m0, m1 = s1 > m1 ? s1 : m1, m2 = s2 > m2 ? s2 : m2, m3 = s3 > m3 ? s3 : m3;
      }
      for (; i < end; ++i) m0 = std::max(m0, plain<scaled>(c, points_[i]));
      most_[b] = std::max(std::max(m0, m1), std::max(m2, m3));
      all = std::max(all, most_[b]);
    }
    return all;
  }

  std::span<const Point> points_;
  double scale_;
  std::vector<double> most_;
};

/// The distance of the farthest point from the center, rounded up once; infinite beyond all doubles.
template <class Point>
double enclosing_radius(std::span<const Point> points, PointScan<Point>& scan, const Point& center) {
  using Spanned = std::conditional_t<std::is_same_v<Point, Point2>, SpannedCircle2, SpannedSphere3>;
  const auto exactly = [](auto... x) { return FineBall<Spanned>{{Ball{x}...}, Ball{-1}}; };
  FineBall<Spanned> most = std::apply(exactly, std::tuple_cat(coordinates(center)));
  struct Far {
    std::size_t point;
    Ball square;
  };
  std::vector<Far> farthest;  // whoever was not certainly nearer than another
  std::vector<std::size_t> open;
  farthest.reserve(std::min<std::size_t>(points.size(), 16)), open.reserve(std::min<std::size_t>(points.size(), 128));
  const double least = scan.rivals(scan.pass(center));
  scan.blocks_from(least, [&](std::size_t first, std::span<const Point> block) {
    open.clear();
    if (farthest.empty()) {
      for (std::size_t i = 0; i < block.size(); ++i) open.push_back(first + i);
    } else {
      not_certainly_inside(most, block, first, open);
    }
    for (const std::size_t i : open) {
      if (scan.distance(center, i) < least) continue;
      const Ball square = most.square_of_distance(points[i]);
      const Unsure<Sign> s = (most.square - square).sign();
      if (s == Unsure{Sign::positive}) continue;
      farthest.push_back({i, square});
      if (s == Unsure{Sign::negative}) most.square = square;
    }
    return true;
  });
  double radius = 0;
  for (const auto& [i, square] : farthest) {
    if ((most.square - square).sign() == Unsure{Sign::positive}) continue;
    const std::optional<double> quick = root(square).rounded(Rounding::up);
    radius = std::max(radius, quick ? *quick : rounded_root(Rounding::up, SquaredDistance<Point>{}, center, points[i]));
  }
  return radius;
}

}  // namespace plumb::figure::sphere
