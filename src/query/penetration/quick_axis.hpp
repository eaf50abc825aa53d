// Separating axis test (SAT): along which axis do two sums of edges overlap least, and are there others?  By doubles, where
// they tell.
//
// Errors derived from the axes' statement (box_axes.hpp), of other sums running ones, leave a few axes that may be the
// nearest; pairs of doubles find the one that is.  Axes at right angles to
// edges that this one is at right angles to as well are the same one: so a box that rests on another is no tie.
// Laws: what is told is what query/penetration/search.hpp would tell; nothing where doubles do not tell it, or where
// several directions are as near.  Of bodies that are apart: a plane between them, which need not be at right angles to
// the way between their nearest points.
// Source: RTCD 4.4.1, 5.2.1; Gottschalk, Lin and Manocha 1996.
// Cost: beside the statement or the zonotope some 100 operations, 1,200 more for each axis that may be as near; no allocation.
#pragma once

#include "query/penetration/separating_axes.hpp"

namespace plumb::query::parting {

/// A facet of the difference as three points, and what of the bodies lies in it.
struct SumFacet {
  std::array<SumLevel, 2> level;
  std::array<Ends, 3> points;
};

/// Across two groups, on the side where their normal leads up or down.
template <class SignAlong>
SumFacet facet_of(const EdgeSum& sum, std::uint32_t i, std::uint32_t j, Sign side, const SignAlong& sign_along) {
  SumFacet f;
  f.level = furthest_of(sum, [&](std::uint32_t g) { return g == i || g == j ? Sign::zero : side * sign_along(g); });
  const Ends base{f.level[0].first, f.level[1].first};
  f.points = {base, base, base};
  Sign turn = side;
  for (std::size_t k = 0; k < 2; ++k) {  // from the base along an edge of each of both groups
    const SumEdge& e = sum.first_of(k == 0 ? i : j);
    f.points[k + 1][e.body] |= 1U << e.bit;
    if (e.body == 1) turn = -turn;
  }
  if (turn == Sign::negative) std::swap(f.points[1], f.points[2]);
  return f;
}

std::optional<SumParting> quick_axis(const EdgeSum& sum, Gap gap);

/// The plane at right angles to two edges of sums, where it has one of them on each side for certain.
std::optional<SumParting> plane_across(const Difference& d, const SumFacetEdges& edges);

}  // namespace plumb::query::parting
