#include "space/bvh/triangle_part.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "plumb/predicates.hpp"

namespace plumb::space {
namespace {

using Numbers = std::array<double, 3>;

struct CutSides {
  Numbers low, high;

  [[nodiscard]] bool is_empty() const { return low[0] > high[0] || low[1] > high[1] || low[2] > high[2]; }
  void take(std::size_t k, double from, double to) {
    low[k] = std::min(low[k], from);
    high[k] = std::max(high[k], to);
  }
};

constexpr double beyond_doubles = std::numeric_limits<double>::infinity();

Numbers numbers_of(const Point3& p) { return {p.x, p.y, p.z}; }

Aabb3 box_of_sides(const CutSides& s) { return {{s.low[0], s.low[1], s.low[2]}, {s.high[0], s.high[1], s.high[2]}}; }

struct Bounds {
  double low, high;
};

/// Of coordinate k of the point of an edge whose coordinate along the axis is `at`, which lies between those of its ends:
/// a guess and a little more, where the predicate says on which side of the edge that lies; else the edge's.
Bounds crossing(const Numbers& from, const Numbers& to, std::size_t axis, double at, std::size_t k) {
  const bool forward = from[axis] < to[axis];
  const Point2 u = forward ? Point2{from[axis], from[k]} : Point2{to[axis], to[k]},
               w = forward ? Point2{to[axis], to[k]} : Point2{from[axis], from[k]};
  const double guess = u.y + (at - u.x) / (w.x - u.x) * (w.y - u.y);
  constexpr double roundings = 0x1p-50;  // a guess, of the size: what the predicate does not confirm is not used
  const double more = roundings * (std::abs(u.y) + std::abs(w.y)), low = guess - more, high = guess + more;
  Bounds bounds{std::min(u.y, w.y), std::max(u.y, w.y)};
  const Bounds edge = bounds;
  const auto inside = [&](double y) { return edge.low < y && y < edge.high; };
  if (inside(low) && orient2d(u, w, {at, low}) != Sign::positive) bounds.low = low;
  if (inside(high) && orient2d(u, w, {at, high}) != Sign::negative) bounds.high = high;
  return bounds;
}

/// What lies between two planes across the axis: a convex polygon of corners and of points where edges cross a plane.
CutSides between(const std::array<Numbers, 3>& corners, std::size_t axis, double least, double most) {
  CutSides hull{{beyond_doubles, beyond_doubles, beyond_doubles}, {-beyond_doubles, -beyond_doubles, -beyond_doubles}};
  for (std::size_t c = 0; c < 3; ++c) {
    const Numbers &from = corners[c], &to = corners[(c + 1) % 3];
    if (least <= from[axis] && from[axis] <= most) {
      for (std::size_t k = 0; k < 3; ++k) hull.take(k, from[k], from[k]);
    }
    for (const double at : {least, most}) {
      const bool crosses = (from[axis] < at && at < to[axis]) || (to[axis] < at && at < from[axis]);
      if (!crosses) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        if (k == axis) {
          hull.take(k, at, at);
          continue;
        }
        const Bounds x = crossing(from, to, axis, at, k);
        hull.take(k, x.low, x.high);
      }
    }
  }
  return hull;
}

}  // namespace

std::optional<Aabb3> part_in(const Triangle3& triangle, const Aabb3& box) {
  const std::array<Numbers, 3> corners{numbers_of(triangle.a), numbers_of(triangle.b), numbers_of(triangle.c)};
  CutSides part{numbers_of(box.min), numbers_of(box.max)};
  for (int pass = 0; pass < 2; ++pass) {  // what one axis has cut off is cut off for the others
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const CutSides own = between(corners, axis, part.low[axis], part.high[axis]);
      for (std::size_t k = 0; k < 3; ++k) {
        part.low[k] = std::max(part.low[k], own.low[k]);
        part.high[k] = std::min(part.high[k], own.high[k]);
      }
      if (part.is_empty()) return {};
    }
  }
  return box_of_sides(part);
}

std::optional<Halves> halves(const Triangle3& triangle, const Aabb3& box) {
  const Numbers low = numbers_of(box.min), high = numbers_of(box.max);
  const auto side = [&](std::size_t k) { return high[k] / 2 - low[k] / 2; };
  std::size_t axis = side(1) > side(0) ? 1 : 0;
  if (side(2) > side(axis)) axis = 2;
  const double middle = low[axis] / 2 + high[axis] / 2;
  if (!(low[axis] < middle && middle < high[axis])) return {};
  CutSides first{low, high}, second{low, high};
  first.high[axis] = second.low[axis] = middle;
  return Halves{part_in(triangle, box_of_sides(first)), part_in(triangle, box_of_sides(second))};
}

}  // namespace plumb::space
