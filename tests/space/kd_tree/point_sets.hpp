// Points for trees, and queries near them: every family of hard coordinates, and what trees find hard.
#pragma once

#include <cmath>
#include <limits>
#include <string_view>
#include <type_traits>
#include <vector>

#include "plumb/certify/compare_distance.hpp"
#include "plumb/certify/sign_of.hpp"
#include "plumb/degenerate.hpp"

namespace plumb::point_sets {

enum class Kind : unsigned char { family, lattice, equal, clusters, ulps, huge, tiny, sphere, mixed };
inline constexpr std::size_t kinds = 9;
inline constexpr std::array<std::string_view, kinds> kind_names{"family", "lattice", "equal",  "clusters", "ulps",
                                                                "huge",   "tiny",    "sphere", "mixed"};

template <class Point>
Point made(double x, double y, double z) {
  if constexpr (std::is_same_v<Point, Point2>) {
    return {x, y};
  } else {
    return {x, y, z};
  }
}

/// One number of a kind that is no family.
inline double number(Kind kind, Entropy& e) {
  const auto unit = [&] { return static_cast<double>(e.below(1u << 20)) * 0x1p-20; };
  const double most = std::numeric_limits<double>::max();
  switch (kind) {
    case Kind::lattice:
      return static_cast<double>(e.within(4));
    case Kind::equal:
      return 0.7;
    case Kind::clusters:
      return static_cast<double>(e.within(2)) + unit() * (e.coin() ? 0x1p-40 : 0x1p-300);
    case Kind::ulps: {
      double x = 1;
      for (std::uint64_t i = e.below(4); i > 0; --i) x = std::nextafter(x, e.coin() ? 2 : 0);
      return x;
    }
    case Kind::huge:
      return (e.coin() ? most : -most) * (e.below(4) == 0 ? 1 : unit());
    case Kind::tiny:
      return static_cast<double>(e.within(6)) * 0x1p-1074;
    case Kind::sphere:
      return unit() - 0.5;
    default: {
      const double sizes[] = {0x1p-1070, 0x1p-600, 0x1p-300, 1, 0x1p300, 0x1p600, 0x1p1020};
      return static_cast<double>(e.within(3)) * sizes[e.below(std::size(sizes))];
    }
  }
}

template <class Point>
std::vector<Point> points(Kind kind, std::size_t n, Entropy& e) {
  if (kind == Kind::family) {
    const Degeneracy degeneracy = degeneracies[e.below(degeneracies.size())];
    const Family family = any_family(e);
    if constexpr (std::is_same_v<Point, Point2>) {
      return points2(family, degeneracy, n, e);
    } else {
      return points3(family, degeneracy, n, e);
    }
  }
  std::vector<Point> all;
  for (std::size_t i = 0; i < n; ++i) {
    double x = number(kind, e), y = number(kind, e), z = number(kind, e);
    if (kind == Kind::sphere) {  // about its center, whose distances differ by rounding alone
      if constexpr (std::is_same_v<Point, Point2>) z = 0;
      const double r = std::sqrt(x * x + y * y + z * z);
      if (r > 0) x /= r, y /= r, z /= r;
    }
    all.push_back(made<Point>(x, y, z));
  }
  return all;
}

/// A point of the set, its like, the center of a sphere, or half-way between two.
template <class Point>
Point query(Kind kind, const std::vector<Point>& all, Entropy& e) {
  const Point &a = all[e.below(all.size())], &b = all[e.below(all.size())];
  if (kind == Kind::sphere && e.below(3) != 0) return made<Point>(0, 0, 0);
  switch (e.below(3)) {
    case 0:
      return a;
    case 1: {
      Point middle = a;
      middle.x = a.x / 2 + b.x / 2, middle.y = a.y / 2 + b.y / 2;
      if constexpr (!std::is_same_v<Point, Point2>) middle.z = a.z / 2 + b.z / 2;
      return middle;
    }
    default:
      return points<Point>(kind, 1, e)[0];
  }
}

/// The numbers of all points, nearest to p first, of equally near ones the lowest: by exact comparisons.
template <class Point>
std::vector<std::uint32_t> sorted_by_distance(const std::vector<Point>& all, const Point& p) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < all.size(); ++i) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t k) {
    return compare_distance(p, all[i], all[k]) == Sign::negative;
  });
  return order;
}

}  // namespace plumb::point_sets
