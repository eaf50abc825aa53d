// Rotating calipers: around which of its edges is a convex polygon's rectangle smallest?  In doubles, for searches.
//
// Laws: the polygon is counterclockwise; the answer has an edge of the polygon on its boundary, as the smallest
// rectangle does (Freeman and Shapira 1975).
// Source: Toussaint 1983, rotating calipers.
// Cost: linear.
#pragma once

#include <cmath>
#include <limits>
#include <span>

#include "plumb/arith/point.hpp"

namespace plumb::figure::frame {

struct Calipers {
  Vector2 direction{1, 0};  // of unit length
  double area = std::numeric_limits<double>::infinity();
};

inline Calipers smallest_rectangle(std::span<const Vector2> polygon) {
  constexpr double point = 0x1p-40;  // a guess, of coordinates up to one: an edge seen end-on has no direction
  Calipers best;
  const std::size_t n = polygon.size();
  const auto next = [n](std::size_t i) { return i + 1 == n ? 0 : i + 1; };
  std::size_t right = 0, top = 0, left = 0;
  bool started = false;
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2 &a = polygon[i], &b = polygon[next(i)];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (!(length > point)) continue;
    const Vector2 u{(b.x - a.x) / length, (b.y - a.y) / length};
    const auto along = [&](std::size_t k) { return polygon[k].x * u.x + polygon[k].y * u.y; };
    const auto above = [&](std::size_t k) { return polygon[k].y * u.x - polygon[k].x * u.y; };
    if (!started) right = next(i);
    const auto advance = [&](std::size_t& k, auto value) {
      for (std::size_t steps = 0; steps < n && value(next(k)) >= value(k); ++steps) k = next(k);
    };
    advance(right, along);
    if (!started) top = right;
    advance(top, above);
    if (!started) left = top;
    advance(left, [&](std::size_t k) { return -along(k); });
    started = true;
    const double area = (along(right) - along(left)) * (above(top) - above(i));
    if (area < best.area) best = {u, area};
  }
  return best;
}

}  // namespace plumb::figure::frame
