// Where is a point to a polygon, what is its area, is it convex?  In GMP rationals, by other ways than the library's.
#pragma once

#include <gmpxx.h>

#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "plumb/figure/basic/convexity.hpp"
#include "plumb/figure/basic/relation.hpp"

namespace plumb_test {

struct Place {
  mpq_class x, y;
};

inline std::vector<Place> exactly(std::span<const plumb::Point2> points) {
  std::vector<Place> places;
  for (const auto& p : points) places.push_back({mpq_class(p.x), mpq_class(p.y)});
  return places;
}

/// Of the sum x_i (y_i+1 - y_i-1), the other form of the shoelace formula.
inline mpq_class twice_area(std::span<const plumb::Point2> chain) {
  const auto p = exactly(chain);
  mpq_class sum = 0;
  for (std::size_t i = 0, n = p.size(); i < n; ++i) sum += p[i].x * (p[(i + 1) % n].y - p[(i + n - 1) % n].y);
  return sum;
}

inline int turn(const Place& a, const Place& b, const Place& c) {
  const mpq_class left = (b.x - a.x) * (c.y - b.y), right = (b.y - a.y) * (c.x - b.x);
  return sgn(mpq_class(left - right));
}

/// By quadrants: how often the chain goes around p is a fourth of the quadrants it passes; nothing on the chain.
inline std::optional<int> winding(std::span<const plumb::Point2> chain, const plumb::Point2& point) {
  const auto all = exactly(chain);
  const Place p{mpq_class(point.x), mpq_class(point.y)};
  const auto quadrant = [&](const Place& v) {
    const bool right = v.x > p.x || (v.x == p.x && v.y < p.y), up = v.y > p.y || (v.y == p.y && v.x > p.x);
    return right && up ? 0 : !right && up ? 1 : !right && !up ? 2 : 3;
  };
  int quarters = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Place &a = all[i], &b = all[(i + 1) % all.size()];
    const int side = turn(a, b, p);
    const mpq_class along = (p.x - a.x) * (p.x - b.x) + (p.y - a.y) * (p.y - b.y);
    if (side == 0 && along <= 0) return {};
    const int step = (quadrant(b) - quadrant(a) + 4) % 4;
    quarters += step == 3 ? -1 : step == 2 ? 2 * side : step;
  }
  return quarters / 4;
}

inline plumb::Location location(std::span<const std::span<const plumb::Point2>> chains, const plumb::Point2& p) {
  int odd = 0;
  for (const auto& chain : chains) {
    const auto turns = winding(chain, p);
    if (!turns) return plumb::Location::boundary;
    odd += *turns;
  }
  return odd % 2 != 0 ? plumb::Location::inside : plumb::Location::outside;
}

/// By the definition: all vertices on one side of every edge, and no edge passed twice; turns by their angles.
inline plumb::PolygonConvexity convexity(std::span<const plumb::Point2> chain) {
  using plumb::PolygonKind;
  const auto all = exactly(chain);
  std::vector<Place> p;
  for (const auto& v : all) {
    if (p.empty() || p.back().x != v.x || p.back().y != v.y) p.push_back(v);
  }
  while (p.size() > 1 && p.front().x == p.back().x && p.front().y == p.back().y) p.pop_back();
  const bool repeated = p.size() < all.size();
  const std::size_t n = p.size();
  bool left = false, right = false, back = false;
  double angle = 0;
  std::vector<Place> corners;
  for (std::size_t i = 0; i < n; ++i) {
    const Place &a = p[(i + n - 1) % n], &b = p[i], &c = p[(i + 1) % n];
    const int t = turn(a, b, c);
    const mpq_class along = (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y);
    left = left || t > 0;
    right = right || t < 0;
    back = back || (t == 0 && along < 0);
    if (t != 0) corners.push_back(b);
    const mpq_class across = (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
    const mpq_class size = abs(across) + abs(along);
    if (size != 0) angle += t * std::atan2(mpq_class(abs(across) / size).get_d(), mpq_class(along / size).get_d());
  }
  if (!left && !right) return {PolygonKind::degenerate, plumb::Sign::zero, 0};
  if (back || (left && right))
    return {PolygonKind::concave, plumb::Sign{static_cast<signed char>(sgn(twice_area(chain)))}, 0};
  const plumb::Sign side = left ? plumb::Sign::positive : plumb::Sign::negative;
  bool one_side = true, distinct = true;
  for (std::size_t i = 0; i < n; ++i) {
    for (const Place& q : p) one_side = one_side && turn(p[i], p[(i + 1) % n], q) * (left ? 1 : -1) >= 0;
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j)
      distinct = distinct && (corners[i].x != corners[j].x || corners[i].y != corners[j].y);
  }
  const int turns = static_cast<int>(std::lround(std::fabs(angle) / (2 * std::acos(-1.0))));
  if (!one_side || !distinct) return {PolygonKind::self_winding, side, turns};
  return {repeated || corners.size() < n ? PolygonKind::convex : PolygonKind::strictly_convex, side, turns};
}

/// Is no double nearer?
inline bool is_nearest(double x, const mpq_class& exact) {
  const double most = std::numeric_limits<double>::max(), infinity = std::numeric_limits<double>::infinity();
  if (std::isinf(x)) return abs(exact) >= mpq_class(most) && (sgn(exact) > 0) == (x > 0);
  const mpq_class off = abs(mpq_class(x) - exact);
  for (const double y : {std::nextafter(x, -infinity), std::nextafter(x, infinity)}) {
    if (std::isfinite(y) && abs(mpq_class(y) - exact) < off) return false;
  }
  return true;
}

}  // namespace plumb_test
