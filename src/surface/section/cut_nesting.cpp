#include "surface/section/cut_nesting.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "surface/section/boxes_around.hpp"
#include "surface/section/contour_tree.hpp"

namespace plumb::surface {
namespace {

using Loop = std::span<const std::uint32_t>;

/// A corner, as seen by the contour that may lie around it.
struct CornerProbe {
  const CutCorners& corners;
  std::uint32_t at;

  [[nodiscard]] Aabb2 place() const { return nearest_box({&at, 1}, corners); }
  [[nodiscard]] Sign compare(std::uint32_t c, std::size_t k) const { return corners.compare(c, at, k); }
  [[nodiscard]] Sign turn(std::uint32_t a, std::uint32_t b) const { return corners.turn(a, b, at); }
};

/// A point between two corners.
struct RationalProbe {
  const CutCorners& corners;
  const RationalPoint2& at;
  const Aabb2& between;

  [[nodiscard]] const Aabb2& place() const { return between; }
  [[nodiscard]] Sign compare(std::uint32_t c, std::size_t k) const {
    const RationalPoint2& p = corners.rational(c);
    return k == 0 ? (p.x - at.x).sign() : (p.y - at.y).sign();
  }
  [[nodiscard]] Sign turn(std::uint32_t a, std::uint32_t b) const {
    const RationalPoint2 &p = corners.rational(a), &q = corners.rational(b);
    return ((q.x - p.x) * (at.y - p.y) - (q.y - p.y) * (at.x - p.x)).sign();
  }
};

/// How often the contour winds around the point; nothing for a point on it.
template <class Probe>
std::optional<int> winding(const ContourTree& around, const Probe& point) {
  int turns = 0;
  bool is_on = false;
  const auto is_above = [&](std::uint32_t c) { return point.compare(c, 1) == Sign::positive; };
  const auto right = [&](std::uint32_t from, std::uint32_t to) { turns += is_above(to) - is_above(from); };
  const auto edge = [&](std::uint32_t a, std::uint32_t b) {
    const Sign height_a = point.compare(a, 1), height_b = point.compare(b, 1);
    const bool up = height_a != Sign::positive && height_b == Sign::positive;
    const bool down = height_a == Sign::positive && height_b != Sign::positive;
    if (up || down) {
      const Sign turn = point.turn(a, b);
      is_on = is_on || turn == Sign::zero;
      if (up && turn == Sign::positive) ++turns;
      if (down && turn == Sign::negative) --turns;
    } else if (height_a == Sign::zero && height_b == Sign::zero) {
      is_on = is_on || point.compare(a, 0) * point.compare(b, 0) != Sign::positive;
    } else if (height_b == Sign::zero) {
      is_on = is_on || point.compare(b, 0) == Sign::zero;
    }
  };
  around.visit(point.place(), right, edge);
  return is_on ? std::nullopt : std::optional(turns);
}

/// The pieces into which corners of `around` cut the edge ab: a point of each.
std::vector<RationalPoint2> points_between(std::uint32_t a, std::uint32_t b, const Aabb2& place,
                                           const ContourTree& around, const CutCorners& corners) {
  const auto before = [](const RationalPoint2& p, const RationalPoint2& q) {
    return p.x < q.x || (p.x == q.x && p.y < q.y);
  };
  const RationalPoint2 &low = std::min(corners.rational(a), corners.rational(b), before),
                       &high = std::max(corners.rational(a), corners.rational(b), before);
  std::vector<RationalPoint2> ends{low, high};
  const auto end = [&](std::uint32_t, std::uint32_t c) {
    if (corners.turn(a, b, c) != Sign::zero) return;
    const RationalPoint2& p = corners.rational(c);
    if (before(low, p) && before(p, high)) ends.push_back(p);
  };
  around.visit(
      place, [](std::uint32_t, std::uint32_t) {}, end);
  std::sort(ends.begin(), ends.end(), before);
  std::vector<RationalPoint2> points;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    points.push_back({(ends[i].x + ends[i + 1].x) * Rational(0.5), (ends[i].y + ends[i + 1].y) * Rational(0.5)});
  return points;
}

/// Corner by corner, wherever they begin.
bool are_equal(Loop a, Loop b) {
  if (a.size() != b.size()) return false;
  const auto start = std::ranges::find(b, a[0]);
  return std::equal(start, b.end(), a.begin()) && std::equal(b.begin(), start, a.end() - (start - b.begin()));
}

/// Nothing where they are the same curve.
std::optional<bool> lies_in(Loop inner, Loop outer, const ContourTree& around, const CutCorners& corners) {
  if (are_equal(inner, outer)) return std::nullopt;
  for (const std::uint32_t c : inner) {
    if (const auto turns = winding(around, CornerProbe{corners, c})) return *turns != 0;
  }
  std::uint32_t a = inner.back();
  for (const std::uint32_t b : inner) {
    const Aabb2 place = nearest_box(std::array{a, b}, corners);
    for (const RationalPoint2& p : points_between(a, b, place, around, corners)) {
      if (const auto turns = winding(around, RationalProbe{corners, p, place})) return *turns != 0;
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
  std::vector<std::uint32_t> closed;
  for (std::uint32_t c = 0; c < joined.size(); ++c) {
    if (joined[c].closed) closed.push_back(c);
  }
  std::vector<Aabb2> places;
  std::vector<Box> boxes;
  for (const std::uint32_t c : closed) {
    contours[c].turn = corners.turn(joined[c].corners);
    places.push_back(nearest_box(joined[c].corners, corners));
    boxes.emplace_back(joined[c].corners, corners);
  }
  // Rounding keeps the order, so that the boxes of nearest doubles lie in each other where the boxes do.
  std::vector<std::vector<std::uint32_t>> around = boxes_around(places);
  std::vector<std::optional<ContourTree>> trees(closed.size());
  for (std::uint32_t i = 0; i < closed.size(); ++i) {
    const auto is_outside = [&](std::uint32_t o) {
      if (!boxes[i].within(boxes[o], corners)) return true;
      const Loop outer = joined[closed[o]].corners;
      if (!trees[o]) trees[o].emplace(outer, corners);
      return !lies_in(joined[closed[i]].corners, outer, *trees[o], corners).value_or(o < i);
    };
    std::erase_if(around[i], is_outside);
    contours[closed[i]].depth = static_cast<std::uint32_t>(around[i].size());
  }
  for (std::uint32_t i = 0; i < closed.size(); ++i) {
    Contour& contour = contours[closed[i]];
    std::uint32_t deepest = 0;  // depth and one
    for (const std::uint32_t o : around[i]) {
      const std::uint32_t depth = contours[closed[o]].depth;
      if (depth >= contour.depth || depth < deepest) continue;
      contour.parent = closed[o];
      deepest = depth + 1;
    }
  }
}

}  // namespace plumb::surface
