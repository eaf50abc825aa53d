// How is a hull in the plane commonly computed?  Four algorithms of textbooks, over signs that somebody else takes.
//
// An answer is the indices of corners, counterclockwise, or none where the algorithm did not end within its bound.
// Laws: (1) with exact signs each returns the strictly extreme points, one index each, for whatever points there are;
// (2) every loop that wrong signs may keep running is bounded by what it needs at most with right ones.
// Source: RTCD 3.9.1 (Andrew), 3.9.2 (quickhull); Jarvis 1973 (gift wrapping); Kettner and others, "Classroom examples
// of robustness problems in geometric computations" (incremental).
// Cost: n log n to n^2 signs.
#pragma once

#include <optional>

#include "lab/stability/hull_signs.hpp"

namespace plumb::lab::stability {

using Corners = std::optional<std::vector<std::uint32_t>>;

struct HullWay {
  std::string name, about;
  Corners (*run)(const HullSigns<2>& signs);
};
const std::vector<HullWay>& hull_ways();

/// Gift wrapping: from the first of the points to the one that has all others on its left, of several the farthest, and
/// on until it is back.  `turn(a, b, c)` is positive where they turn left; points come in order.
template <std::size_t D, class Turn>
Corners wrapped(const HullSigns<D>& s, std::span<const std::uint32_t> order, const Turn& turn) {
  std::vector<std::uint32_t> corners;
  std::uint32_t at = order.front();
  do {
    if (corners.size() == order.size()) return std::nullopt;
    corners.push_back(at);
    std::uint32_t next = at;
    for (const std::uint32_t p : order) {
      if (p == at) continue;
      const int side = next == at ? -1 : turn(at, next, p);
      const bool beyond = side == 0 && (s.before(at, next) ? s.before(next, p) : s.before(p, next));
      if (side < 0 || beyond) next = p;
    }
    at = next;
  } while (at != order.front());
  return corners;
}

}  // namespace plumb::lab::stability
