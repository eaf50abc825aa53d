// What a section must be, by rational arithmetic on its corners alone.
#pragma once

#include <gtest/gtest.h>

#include <set>

#include "plumb/query/ray_parity.hpp"
#include "plumb/surface/section.hpp"

namespace plumb::oracle {

using Flat = std::array<Rational, 2>;

/// The corners along two axes that show the plane; `turned` where they show it from below.
struct Shown {
  std::size_t u, v;
  bool turned;
};

inline Flat flat(const RationalPoint3& p, const Shown& s) {
  const std::array<Rational, 3> x{p.x, p.y, p.z};
  return {x[s.u], x[s.v]};
}

inline std::vector<std::vector<Flat>> flat_contours(const TriangleMesh& mesh, const Section& cut, const Shown& s) {
  std::vector<std::vector<Flat>> contours;
  for (const Contour& c : cut.contours) {
    auto& points = contours.emplace_back();
    for (const SectionCorner& corner : c.corners)
      points.push_back(flat(rational_point(exact_corner(mesh, cut.plane, corner)), s));
  }
  return contours;
}

inline Rational doubled_area(const std::vector<Flat>& loop) {
  Rational sum;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Flat &p = loop[i], &q = loop[(i + 1) % loop.size()];
    sum = sum + (p[0] * q[1] - q[0] * p[1]);
  }
  return sum;
}

/// How often the loop winds around p, counterclockwise; nothing on it.  By the crossings of the ray along u.
inline std::optional<int> winding(const std::vector<Flat>& loop, const Flat& p) {
  int turns = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Flat &a = loop[i], &b = loop[(i + 1) % loop.size()];
    const Rational cross = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
    if (cross.sign() == Sign::zero) {
      const Rational along =
          (p[0] - a[0]) * (p[0] - b[0]) + (p[1] - a[1]) * (p[1] - b[1]);  // not positive between a and b
      if (along.sign() != Sign::positive) return std::nullopt;
    }
    if (a[1] <= p[1] && b[1] > p[1] && cross.sign() == Sign::positive) ++turns;
    if (a[1] > p[1] && b[1] <= p[1] && cross.sign() == Sign::negative) --turns;
  }
  return turns;
}

/// The laws that need no mesh: turns, each corner once, rounding, the forest.
inline void expect_lawful(const TriangleMesh& mesh, const Section& cut, const Shown& shown) {
  const auto contours = flat_contours(mesh, cut, shown);
  for (std::size_t i = 0; i < contours.size(); ++i) {
    const Contour& c = cut.contours[i];
    EXPECT_EQ(std::set<Flat>(contours[i].begin(), contours[i].end()).size(), contours[i].size());
    for (const SectionCorner& corner : c.corners)
      EXPECT_EQ(corner.nearest, approximate(exact_corner(mesh, cut.plane, corner)));
    if (!c.closed) {
      EXPECT_FALSE(c.parent.has_value());
      EXPECT_EQ(c.turn, Sign::zero);
      continue;
    }
    EXPECT_GE(contours[i].size(), 3U);
    const Sign turn = doubled_area(contours[i]).sign();
    EXPECT_EQ(c.turn, shown.turned ? -turn : turn);
    EXPECT_EQ(c.parent.has_value(), c.depth > 0);
    EXPECT_LT(c.parent ? cut.contours[*c.parent].depth : 0, std::max(c.depth, 1U));
  }
}

/// All contours about p; nothing where p is on one.
inline std::optional<int> winding(const std::vector<std::vector<Flat>>& contours, const Flat& p) {
  int turns = 0;
  for (const auto& loop : contours) {
    const auto one = winding(loop, p);
    if (!one) return std::nullopt;
    turns += *one;
  }
  return turns;
}

}  // namespace plumb::oracle
