#include "surface/cut_nesting.hpp"

#include <algorithm>
#include <optional>

namespace plumb::surface {
namespace {

using Loop = std::span<const std::uint32_t>;

/// A corner, as seen by the contour that may lie around it.
struct CornerProbe {
  const CutCorners& corners;
  std::uint32_t at;

  [[nodiscard]] Sign compare(std::uint32_t c, std::size_t k) const { return corners.compare(c, at, k); }
  [[nodiscard]] Sign turn(std::uint32_t a, std::uint32_t b) const { return corners.turn(a, b, at); }
  /// Surely on one side of the corner?  The order of the nearest doubles is that of the points, where they differ.
  [[nodiscard]] Sign beside(std::uint32_t a, std::uint32_t b) const {
    const double x = corners.nearest(at, 0), xa = corners.nearest(a, 0), xb = corners.nearest(b, 0);
    return xa > x && xb > x ? Sign::positive : xa < x && xb < x ? Sign::negative : Sign::zero;
  }
};

/// Any point.
struct RationalProbe {
  const CutCorners& corners;
  const RationalPoint2& at;

  [[nodiscard]] Sign compare(std::uint32_t c, std::size_t k) const {
    const RationalPoint2& p = corners.rational(c);
    return k == 0 ? (p.x - at.x).sign() : (p.y - at.y).sign();
  }
  [[nodiscard]] Sign turn(std::uint32_t a, std::uint32_t b) const {
    const RationalPoint2 &p = corners.rational(a), &q = corners.rational(b);
    return ((q.x - p.x) * (at.y - p.y) - (q.y - p.y) * (at.x - p.x)).sign();
  }
  [[nodiscard]] Sign beside(std::uint32_t, std::uint32_t) const { return Sign::zero; }
};

/// How often the loop winds around the point; nothing for a point on it.
template <class Probe>
std::optional<int> winding(Loop loop, const Probe& point) {
  int turns = 0;
  std::uint32_t a = loop.back();
  Sign height_a = point.compare(a, 1);
  for (const std::uint32_t b : loop) {
    const Sign height_b = point.compare(b, 1);
    const bool up = height_a != Sign::positive && height_b == Sign::positive;
    const bool down = height_a == Sign::positive && height_b != Sign::positive;
    if (up || down) {
      Sign right = point.beside(a, b);
      if (right == Sign::zero) {
        const Sign turn = point.turn(a, b);
        if (turn == Sign::zero) return std::nullopt;
        right = up ? turn : -turn;
      }
      if (right == Sign::positive) turns += up ? 1 : -1;
    } else if (height_a == Sign::zero && height_b == Sign::zero &&
               point.compare(a, 0) * point.compare(b, 0) != Sign::positive) {
      return std::nullopt;
    } else if (height_b == Sign::zero && point.compare(b, 0) == Sign::zero) {
      return std::nullopt;
    }
    a = b, height_a = height_b;
  }
  return turns;
}

/// The pieces into which corners of `around` cut the edge ab: a point of each.
std::vector<RationalPoint2> points_between(std::uint32_t a, std::uint32_t b, Loop around, const CutCorners& corners) {
  const auto before = [](const RationalPoint2& p, const RationalPoint2& q) {
    return p.x < q.x || (p.x == q.x && p.y < q.y);
  };
  const RationalPoint2 &low = std::min(corners.rational(a), corners.rational(b), before),
                       &high = std::max(corners.rational(a), corners.rational(b), before);
  std::vector<RationalPoint2> ends{low, high};
  for (const std::uint32_t c : around) {
    const RationalPoint2& p = corners.rational(c);
    if (corners.turn(a, b, c) == Sign::zero && before(low, p) && before(p, high)) ends.push_back(p);
  }
  std::sort(ends.begin(), ends.end(), before);
  std::vector<RationalPoint2> points;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    points.push_back({(ends[i].x + ends[i + 1].x) * Rational(0.5), (ends[i].y + ends[i + 1].y) * Rational(0.5)});
  return points;
}

/// Nothing where they are the same curve.
std::optional<bool> lies_in(Loop inner, Loop outer, const CutCorners& corners) {
  for (const std::uint32_t c : inner) {
    if (const auto turns = winding(outer, CornerProbe{corners, c})) return *turns != 0;
  }
  std::uint32_t a = inner.back();
  for (const std::uint32_t b : inner) {
    for (const RationalPoint2& p : points_between(a, b, outer, corners)) {
      if (const auto turns = winding(outer, RationalProbe{corners, p})) return *turns != 0;
    }
    a = b;
  }
  return std::nullopt;
}

/// The corners that are the least and the greatest of each coordinate.
struct Box {
  std::array<std::uint32_t, 2> min, max;

  Box(Loop loop, const CutCorners& corners) {
    for (std::size_t k = 0; k < 2; ++k) {
      const auto less = [&](std::uint32_t a, std::uint32_t b) { return corners.compare(a, b, k) == Sign::negative; };
      min[k] = *std::ranges::min_element(loop, less);
      max[k] = *std::ranges::max_element(loop, less);
    }
  }
  [[nodiscard]] bool within(const Box& b, const CutCorners& corners) const {
    for (std::size_t k = 0; k < 2; ++k) {
      if (corners.compare(min[k], b.min[k], k) == Sign::negative) return false;
      if (corners.compare(max[k], b.max[k], k) == Sign::positive) return false;
    }
    return true;
  }
};

}  // namespace

void nest_contours(std::span<const CutContour> joined, const CutCorners& corners, std::span<Contour> contours) {
  std::vector<Box> boxes;
  for (const CutContour& c : joined) boxes.emplace_back(c.corners, corners);
  std::vector<std::vector<std::uint32_t>> around(joined.size());
  for (std::uint32_t c = 0; c < joined.size(); ++c) {
    if (!joined[c].closed) continue;
    contours[c].turn = corners.turn(joined[c].corners);
    for (std::uint32_t other = 0; other < joined.size(); ++other) {
      if (other == c || !joined[other].closed || !boxes[c].within(boxes[other], corners)) continue;
      if (lies_in(joined[c].corners, joined[other].corners, corners).value_or(other < c)) around[c].push_back(other);
    }
    contours[c].depth = static_cast<std::uint32_t>(around[c].size());
  }
  for (std::uint32_t c = 0; c < joined.size(); ++c) {
    const auto deepest = std::ranges::max_element(around[c], {}, [&](std::uint32_t o) {
      return contours[o].depth < contours[c].depth ? contours[o].depth + 1 : 0;
    });
    if (deepest != around[c].end() && contours[*deepest].depth < contours[c].depth) contours[c].parent = *deepest;
  }
}

}  // namespace plumb::surface
