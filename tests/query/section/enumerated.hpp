// What lies in some halfspaces, by brute force over rationals: all places where three planes meet.
//
// Laws: exact; the extreme points of the set, and directions in which it goes on forever, all extreme ones among them.
// Cost: the cube of the halfspaces, some us each.
#pragma once

#include <algorithm>
#include <set>
#include <vector>

#include "query/body/exact_sets.hpp"

namespace plumb::exact {

inline Coordinates cross(const Coordinates& u, const Coordinates& v) {
  Coordinates w(3);
  for (std::size_t i = 0; i < 3; ++i) w[i] = u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3];
  return w;
}

/// normal . x <= offset.
struct Bound {
  Coordinates normal;
  Rational offset;
};
using Bounds = std::vector<Bound>;

template <class Vector>
Bound bound(const Vector& normal, double offset, int sign = 1) {
  return {combination({0, 0, 0}, sign, of(normal)), sign * Rational(offset)};
}
/// Of corners that span space: the planes of three of them that have all others to one side.
inline Bounds supports(const std::vector<Coordinates>& p) {
  Bounds all;
  std::set<std::vector<bool>> seen;
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < p.size(); ++j) {
      for (std::size_t k = std::min(i, j) + 1; k < p.size(); ++k) {
        if (i == j || k == j || k < i) continue;
        const Coordinates n = cross(difference(p[j], p[i]), difference(p[k], p[i]));
        std::vector<bool> on;
        bool holds = square(n) != 0;
        for (const Coordinates& q : p) {
          const int side = sgn(dot(n, difference(q, p[i])));
          on.push_back(side == 0);
          holds = holds && side <= 0;
        }
        if (holds && seen.insert(on).second) all.push_back({n, dot(n, p[i])});
      }
    }
  }
  return all;
}

/// What lies in all of them, from all places where three planes meet and all directions of two.
struct Enumerated {
  std::vector<Coordinates> points, directions;
  bool has_corners = false;  // three normals are independent
};
inline Enumerated enumerate(const Bounds& all) {
  Enumerated set;
  const auto insert = [](std::vector<Coordinates>& to, const Coordinates& x) {
    if (std::ranges::find(to, x) == to.end()) to.push_back(x);
  };
  const auto holds = [&](const Coordinates& x, bool is_direction) {
    return std::ranges::all_of(all, [&](const Bound& b) { return dot(b.normal, x) <= (is_direction ? 0 : b.offset); });
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Coordinates line = cross(all[i].normal, all[j].normal);
      for (const int sign : {1, -1}) {
        const Coordinates d = combination({0, 0, 0}, sign, line);
        if (square(d) != 0 && holds(d, true)) insert(set.directions, d);
      }
      for (std::size_t k = 0; k < j; ++k) {
        const Rational volume = dot(line, all[k].normal);
        if (volume == 0) continue;
        set.has_corners = true;
        Coordinates x = combination({0, 0, 0}, all[k].offset, line);
        x = combination(x, all[i].offset, cross(all[j].normal, all[k].normal));
        x = combination(x, all[j].offset, cross(all[k].normal, all[i].normal));
        x = combination({0, 0, 0}, 1 / volume, x);
        if (holds(x, false)) insert(set.points, x);
      }
    }
  }
  return set;
}

}  // namespace plumb::exact
