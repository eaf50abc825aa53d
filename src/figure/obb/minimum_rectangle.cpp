// The rectangle of least area: calipers that turn by exact signs, and areas compared exactly.
#include <cmath>
#include <optional>

#include "arith/vec.hpp"
#include "figure/basic/finite_parts.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/sign_of.hpp"
#include "plumb/figure/hull/hull2.hpp"
#include "plumb/figure/obb/minimum_obb.hpp"
#include "plumb/figure/obb/obb.hpp"

namespace plumb {
namespace {

// The hull's edge ab, and the vertices that are farthest back, ahead and above it.
struct Rectangle {
  Point2 a, b, back, ahead, above;
};

// Area of the first against that of the second: each is ((b - a) . (ahead - back)) ((b - a) x (above - a)) / |ab|^2.
struct CompareAreas {
  static constexpr std::string_view name = "minimum_obb";
  static constexpr int points = 10, dimension = 2;

  template <class T>
  constexpr auto operator()(const std::array<T, 20>& p) const {
    const auto x = [&](std::size_t from, std::size_t to) { return p[2 * to] - p[2 * from]; };
    const auto y = [&](std::size_t from, std::size_t to) { return p[2 * to + 1] - p[2 * from + 1]; };
    const auto area = [&](std::size_t i) {
      return (x(i, i + 1) * x(i + 2, i + 3) + y(i, i + 1) * y(i + 2, i + 3)) *
             (x(i, i + 1) * y(i, i + 4) - y(i, i + 1) * x(i, i + 4));
    };
    const auto square = [&](std::size_t i) { return x(i, i + 1) * x(i, i + 1) + y(i, i + 1) * y(i, i + 1); };
    return area(0) * square(5) - area(5) * square(0);
  }
};

bool smaller(const Rectangle& r, const Rectangle& s) {
  return sign_of(CompareAreas{}, r.a, r.b, r.back, r.ahead, r.above, s.a, s.b, s.back, s.ahead, s.above) ==
         Sign::negative;
}

// (b - a) . (d - c) and (b - a) x (d - c).
Sign along(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return sign_of([](auto ax, auto ay, auto bx, auto by, auto cx, auto cy, auto dx,
                    auto dy) { return (bx - ax) * (dx - cx) + (by - ay) * (dy - cy); },
                 a, b, c, d);
}
Sign above(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return sign_of([](auto ax, auto ay, auto bx, auto by, auto cx, auto cy, auto dx,
                    auto dy) { return (bx - ax) * (dy - cy) - (by - ay) * (dx - cx); },
                 a, b, c, d);
}

Rectangle least_area(const std::vector<Point2>& polygon) {
  const std::size_t n = polygon.size();
  const auto next = [n](std::size_t i) { return i + 1 == n ? 0 : i + 1; };
  Rectangle best{};
  std::size_t ahead = 1, highest = 1, back = 1;
  for (std::size_t i = 0; i < n; ++i) {
    const Point2 &a = polygon[i], &b = polygon[next(i)];
    // Ends, for the edges of a convex polygon, which lead all around, do not all go one way.
    const auto advance = [&](std::size_t& k, auto further) {
      while (further(polygon[k], polygon[next(k)])) k = next(k);
    };
    advance(ahead, [&](const Point2& p, const Point2& q) { return along(a, b, p, q) == Sign::positive; });
    if (i == 0) highest = ahead;
    advance(highest, [&](const Point2& p, const Point2& q) { return above(a, b, p, q) == Sign::positive; });
    if (i == 0) back = highest;
    advance(back, [&](const Point2& p, const Point2& q) { return along(a, b, p, q) == Sign::negative; });
    const Rectangle r{a, b, polygon[back], polygon[ahead], polygon[highest]};
    if (i == 0 || smaller(r, best)) best = r;
  }
  return best;
}

// Halved where the difference is beyond doubles: only its direction counts.
std::array<Vector2, 2> axes_along(const Point2& a, const Point2& b) {
  Vector2 d{b.x - a.x, b.y - a.y};
  if (!(std::fabs(d.x) + std::fabs(d.y) < std::numeric_limits<double>::infinity()))
    d = {b.x / 4 - a.x / 4, b.y / 4 - a.y / 4};
  return {d, Vector2{0.0 - d.y, d.x}};
}

std::optional<Obb2> fitted(const std::array<Vector2, 2>& axes, std::span<const Point2> points) {
  try {
    return fit_obb(axes, points);
  } catch (const BeyondDoubles&) {
    return {};
  }
}

// Of the boxes as they are, whose axes and half extents are rounded.
bool smaller(const Obb2& a, const Obb2& b) {
  const auto area = [](const Obb2& box) {
    const std::array axes{arith::vec<BigDyadic>(box.axes[0]), arith::vec<BigDyadic>(box.axes[1])};
    return magnitude(BigDyadic(box.half.x) * BigDyadic(box.half.y) * arith::cross(axes[0], axes[1]).z);
  };
  return (area(a) - area(b)).sign() == Sign::negative;
}

}  // namespace

Obb2 minimum_obb(std::span<const Point2> points) {
  figure::require_finite_points("minimum_obb", "points", points);
  if (points.empty()) throw InvalidShape("minimum_obb: no points; give at least one");
  std::vector<Point2> polygon;
  // Of equal points any stands for all: -0 is not to show.
  for (const std::uint32_t i : convex_hull(points).vertices) polygon.push_back({points[i].x + 0.0, points[i].y + 0.0});
  constexpr std::array upright{Vector2{1, 0}, Vector2{0, 1}};
  if (polygon.size() == 1) return fit_obb(upright, polygon);
  const Rectangle best = polygon.size() == 2 ? Rectangle{polygon[0], polygon[1], {}, {}, {}} : least_area(polygon);
  const auto along = axes_along(best.a, best.b);
  const auto box = fitted(along, polygon), straight = fitted(upright, polygon);
  if (!box) return straight ? *straight : fit_obb(along, polygon);
  return straight && smaller(*straight, *box) ? *straight : *box;
}

}  // namespace plumb
