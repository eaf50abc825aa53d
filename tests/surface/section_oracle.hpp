// What every section must be, whatever the mesh.
#pragma once

#include <gtest/gtest.h>

#include <set>

#include "flat_contours.hpp"
#include "plumb/query/ray_parity.hpp"

namespace plumb::oracle {

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

}  // namespace plumb::oracle
