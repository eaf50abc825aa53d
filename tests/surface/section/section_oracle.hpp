// What every section must be, whatever the mesh.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "plumb/query/ray/parity.hpp"
#include "surface/section/flat_contours.hpp"

namespace plumb::oracle {

inline bool is_boxed(const std::vector<Flat>& inner, const std::vector<Flat>& outer) {
  for (std::size_t k = 0; k < 2; ++k) {
    const auto less = [&](const Flat& p, const Flat& q) { return p[k] < q[k]; };
    const auto [a, b] = std::ranges::minmax_element(inner, less);
    const auto [c, d] = std::ranges::minmax_element(outer, less);
    if ((*a)[k] < (*c)[k] || (*d)[k] < (*b)[k]) return false;
  }
  return true;
}

/// Does one wind around what of the other is not on it?  Both answers where points between its corners disagree, none
/// where they are the same curve.
inline std::set<bool> lies_in(const std::vector<Flat>& inner, const std::vector<Flat>& outer) {
  if (!is_boxed(inner, outer)) return {false};
  for (const Flat& corner : inner) {
    if (const auto turns = winding(outer, corner)) return {*turns != 0};
  }
  std::set<bool> answers;
  for (std::size_t i = 0; i < inner.size(); ++i) {
    const Flat &a = inner[i], &b = inner[(i + 1) % inner.size()];
    const Flat along{b[0] - a[0], b[1] - a[1]};
    const auto progress = [&](const Flat& p) { return (p[0] - a[0]) * along[0] + (p[1] - a[1]) * along[1]; };
    std::set<Rational> stops{Rational(0), progress(b)};  // wherever a corner of the other is level with the edge
    for (const Flat& p : outer) {
      if (Rational(0) < progress(p) && progress(p) < progress(b)) stops.insert(progress(p));
    }
    for (auto stop = stops.begin(); std::next(stop) != stops.end(); ++stop) {
      const Rational at = (*stop + *std::next(stop)) / (Rational(2) * progress(b));
      if (const auto turns = winding(outer, {a[0] + at * along[0], a[1] + at * along[1]})) answers.insert(*turns != 0);
    }
  }
  return answers;
}

/// Depth and parent of each closed contour, from all others one by one.
inline void expect_nested(const TriangleMesh& mesh, const Section& cut) {
  const Vector3& n = std::get<Plane3>(cut.plane).normal;
  const std::array<double, 3> sizes{std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)};
  const auto along = static_cast<std::size_t>(std::ranges::max_element(sizes) - sizes.begin());
  const auto contours = flat_contours(mesh, cut, {(along + 1) % 3, (along + 2) % 3, false});
  for (std::size_t i = 0; i < contours.size(); ++i) {
    const Contour& c = cut.contours[i];
    if (!c.closed) continue;
    std::uint32_t depth = 0, deepest = 0;
    bool is_parent_around = !c.parent;
    for (std::size_t o = 0; o < contours.size(); ++o) {
      if (o == i || !cut.contours[o].closed) continue;
      const std::set<bool> answers = lies_in(contours[i], contours[o]);
      if (answers.size() == 2) return;
      if (answers.empty() ? i < o : !*answers.begin()) continue;
      ++depth;
      is_parent_around = is_parent_around || c.parent == o;
      if (cut.contours[o].depth < c.depth) deepest = std::max(deepest, cut.contours[o].depth + 1);
    }
    EXPECT_EQ(c.depth, depth);
    EXPECT_TRUE(is_parent_around);
    EXPECT_EQ(c.parent ? cut.contours[*c.parent].depth + 1 : 0, deepest);
  }
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
  }
  expect_nested(mesh, cut);
}

}  // namespace plumb::oracle
