// Where is a triangular piece best cut?  A guess in plain doubles, without a bound: any cut is true.
//
// Where an edge crosses the border of the triangle that is nearest to most of the piece, so that one part has it for
// nearest; else half way along the longest edge.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "plumb/figure/basic/simplex.hpp"

namespace plumb::space {

/// From corner `edge` to the next, this part of the way; above 0 and below 1.
struct PieceCut {
  std::size_t edge;
  double part;
};

inline PieceCut halving(const std::array<Point3, 3>& corners) {
  const auto length = [&](std::size_t i) {
    const Point3 &p = corners[i], &q = corners[(i + 1) % 3];
    return std::max({std::fabs(p.x - q.x), std::fabs(p.y - q.y), std::fabs(p.z - q.z)});
  };
  const std::size_t edge = length(1) > length(0) ? 1 : 0;
  return {length(2) > length(edge) ? std::size_t{2} : edge, 0.5};
}

/// The crossing that is nearest to the middle of an edge.
inline std::optional<PieceCut> border_crossing(const std::array<Point3, 3>& corners, const Triangle3& t) {
  const std::array ends{t.a, t.b, t.c};
  const auto way = [](const Point3& p, const Point3& q) { return Vector3{q.x - p.x, q.y - p.y, q.z - p.z}; };
  const auto cross_of = [](const Vector3& u, const Vector3& v) {
    return Vector3{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  };
  const Vector3 normal = cross_of(way(t.a, t.b), way(t.a, t.c));
  std::array<std::array<double, 3>, 3> within{};  // [corner][edge of t]: positive on the side of t
  double largest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 inward = cross_of(normal, way(ends[k], ends[(k + 1) % 3]));
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3 v = way(ends[k], corners[i]);
      within[i][k] = inward.x * v.x + inward.y * v.y + inward.z * v.z;
      largest = std::max(largest, std::fabs(within[i][k]));
    }
  }
  // Guesses of where a cut pays: past a side by roundings alone, and not right at a corner.
  constexpr double beside = 0x1p-30, least_part = 0x1p-6;
  std::optional<PieceCut> best;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto &from = within[i], &to = within[(i + 1) % 3];
    for (std::size_t k = 0; k < 3; ++k) {
      if ((from[k] < 0) == (to[k] < 0)) continue;
      const double part = from[k] / (from[k] - to[k]);
      const auto on_side = [&](std::size_t other) {
        return other == k || from[other] + part * (to[other] - from[other]) >= -beside * largest;
      };
      if (!(part > least_part && part < 1 - least_part) || !on_side(0) || !on_side(1) || !on_side(2)) continue;
      if (!best || std::fabs(part - 0.5) < std::fabs(best->part - 0.5)) best = PieceCut{i, part};
    }
  }
  return best;
}

}  // namespace plumb::space
