// The steps of a hull in the plane: what is left out first, and two ways to go on.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/certify/sign_of.hpp"
#include "plumb/figure/hull/hull2.hpp"

namespace plumb::figure::hull2 {

/// A point with its place in the input.
struct Indexed {
  Point2 p;
  std::uint32_t index;
};

/// By x, then y, then index: equal points follow one another, the one that stands for them first.
inline bool before(const Indexed& a, const Indexed& b) {
  if (a.p.x != b.p.x) return a.p.x < b.p.x;
  if (a.p.y != b.p.y) return a.p.y < b.p.y;
  return a.index < b.index;
}

inline Sign turn(const Indexed& a, const Indexed& b, const Indexed& c) {
  return sign_of(predicates::Orient2d{}, a.p, b.p, c.p);
}

/// Sorted, one of equal points.
void sort_distinct(std::vector<Indexed>& points, Execution execution = Execution::serial);

/// Those of the points that may lie on the hull's boundary, in their order.  Throws NonFinite.
std::vector<Indexed> candidates(std::span<const Point2> points, const Hull2Options& options);

/// Of sorted, distinct points.
Hull2 monotone_chain(std::span<const Indexed> points, bool all_boundary_points);

/// Of points in any order.
Hull2 quickhull(std::vector<Indexed> points, bool all_boundary_points);

}  // namespace plumb::figure::hull2
