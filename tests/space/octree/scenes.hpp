// Boxes and points of the families that indexes are wrong on: touching and off by an ulp, equal, nested, of hugely
// different sizes, at the ends of the doubles.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "plumb/certify/accepted.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/space/octree/cell_frame.hpp"

namespace plumb::scenes {

enum class Family { uniform, clustered, lattice, ulps, equal, nested, sizes, extreme, special };
inline constexpr std::array families{Family::uniform, Family::clustered, Family::lattice, Family::ulps,   Family::equal,
                                     Family::nested,  Family::sizes,     Family::extreme, Family::special};

inline double nudged(double x, Entropy& e) {
  const std::int64_t by = e.within(1);
  return by == 0 ? x : std::nextafter(x, by > 0 ? 1e9 : -1e9);
}

/// The two ends along an axis.
inline std::array<double, 2> ends_of(Family family, Entropy& e) {
  double a = 0, b = 0;
  switch (family) {
    case Family::uniform:
      a = signed_unit_coordinate(e), b = a + 0.25 * unit_coordinate(e);
      break;
    case Family::clustered:
      a = static_cast<double>(e.within(2)) + 1e-6 * unit_coordinate(e), b = a + 1e-7 * unit_coordinate(e);
      break;
    case Family::lattice:
      a = static_cast<double>(e.within(4)), b = a + static_cast<double>(e.below(3));
      break;
    case Family::ulps:
      a = nudged(static_cast<double>(e.within(2)), e), b = nudged(a + static_cast<double>(e.below(2)), e);
      break;
    case Family::equal:
      a = 0.75, b = 1.5;
      break;
    case Family::nested:
      b = std::ldexp(1.0, static_cast<int>(e.within(30))), a = e.coin() ? -b : 0;
      break;
    case Family::sizes:
      a = wide_coordinate(e), b = a + std::ldexp(unit_coordinate(e), static_cast<int>(e.within(40)));
      break;
    case Family::extreme:
      a = extreme_coordinate(e), b = e.coin() ? a : extreme_coordinate(e);
      break;
    case Family::special:
      a = special_coordinate(e), b = special_coordinate(e);
      break;
  }
  return {std::min(a, b), std::max(a, b)};
}

template <std::size_t D>
typename CellKinds<D>::Box box_of(Family family, Entropy& e) {
  const auto x = ends_of(family, e), y = ends_of(family, e);
  if constexpr (D == 2) {
    return {{x[0], y[0]}, {x[1], y[1]}};
  } else {
    const auto z = ends_of(family, e);
    return {{x[0], y[0], z[0]}, {x[1], y[1], z[1]}};
  }
}
template <std::size_t D>
typename CellKinds<D>::Point point_of(Family family, Entropy& e) {
  const auto box = box_of<D>(family, e);
  return e.coin() ? box.min : box.max;
}

template <std::size_t D>
std::vector<typename CellKinds<D>::Box> boxes_of(Family family, std::size_t n, Entropy& e) {
  std::vector<typename CellKinds<D>::Box> boxes;
  for (std::size_t i = 0; i < n; ++i) boxes.push_back(box_of<D>(family, e));
  return boxes;
}
template <std::size_t D>
std::vector<typename CellKinds<D>::Point> points_of(Family family, std::size_t n, Entropy& e) {
  std::vector<typename CellKinds<D>::Point> points;
  for (std::size_t i = 0; i < n; ++i) points.push_back(point_of<D>(family, e));
  return points;
}

/// What replays a case.
inline std::string about(std::uint64_t run, std::uint64_t number, Family family) {
  return "Entropy e(" + std::to_string(run) + ", " + std::to_string(number) + "), family " +
         std::to_string(static_cast<int>(family));
}

/// Calls test(family, entropy, text) for so many cases of each family.
template <class Test>
void on_scenes(std::uint64_t run, std::size_t cases, const Test& test) {
  for (std::size_t i = 0; i < cases * families.size(); ++i) {
    const Family family = families[i % families.size()];
    Entropy e(run, i);
    test(family, e, about(run, i, family));
  }
}

}  // namespace plumb::scenes
