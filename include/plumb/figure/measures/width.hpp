// Width, least thickness: between which two parallel planes, nearest to each other, do all points lie?
//
//   const PointsWidth w = least_width(points);
//   w.width, w.squared                                  // rounded up once, and exactly
//   w.squared <= Rational(length) * Rational(length)    // as thin as that?
//
// Laws: (1) the exact least distance of two parallel planes that hold all points between them; its square is rational.
// (2) The planes touch the hull at a face and a vertex, or at two edges: `one` and `other` are the points that they are
// made of, three and one, or two and two; normal_edges says which: the normal is the cross product of both edges.  (3)
// Points in one plane have width 0, and `one` and `other` are empty.  (4) The width depends on the points alone; of
// planes equally near those are named that come first in the hull's order.
// No points throw InvalidShape, NaN and infinity NonFinite.
// Source: Houle and Toussaint 1988.
// Cost: the hull's; then each pair of its edges, some 0.3 us, and each pair of a face and a vertex.  Bounded by n^3 signs
// for the hull, and n^2 for n vertices of it, on integers as long as the exponents' span.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/arith/point.hpp"
#include "plumb/arith/rational.hpp"

namespace plumb {

struct PointsWidth {
  Rational squared;
  double width = 0;  // its root, rounded up
  std::vector<std::uint32_t> one, other;
  std::array<std::array<std::uint32_t, 2>, 2> normal_edges{};  // from a point to another
};

PointsWidth least_width(std::span<const Point3> points);

}  // namespace plumb
