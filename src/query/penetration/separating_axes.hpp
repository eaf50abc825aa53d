// Separating axis test (SAT): along which of fifteen axes is the least translation that parts two boxes?  Of
// rectangles, segments and points as well: of whatever is a sum of edges.
//
// The Minkowski difference of such bodies is a zonotope: its facets are at right angles to each two of the edges that
// are not parallel, two for each, as far from its middle as half of the other edges lead along the normal.
// Laws: exact, by running errors, then integers; what is told is what query/penetration/search.hpp would tell.
// Where all edges are along the axes of space, three differences take the place of the fifteen axes.  A difference
// without an inside is not answered here.
// Source: RTCD 4.4.1, 5.2.1; Gottschalk, Lin and Manocha 1996.
// Cost: along the axes of space some hundred operations, else some two thousand; no allocation where doubles decide.
#pragma once

#include "plumb/arith/ball.hpp"
#include "query/penetration/edge_sum.hpp"
#include "query/penetration/parted.hpp"

namespace plumb::query::parting {

/// The edges that a facet's normal is at right angles to.
using SumFacetEdges = std::array<EdgeName, 2>;

/// Which of several planes between sums that are apart: one that is likely to hold a nearest point of each, or the one of
/// the widest gap, as far as doubles tell.
enum class Gap : unsigned char { likely, widest };

struct SumParting {
  enum class Known : unsigned char { nothing, apart, parting };
  Known known = Known::nothing;
  std::optional<Parting> parting{};      // of what is apart a plane between them, where it is known
  std::array<SumLevel, 2> level{};       // where the first touches the second
  std::array<bool, 2> is_plain{};        // the body's edges are known to be independent
  std::optional<Ball> overlap{};         // along an axis of space, where it is known
  bool is_widest = true;                 // no other plane has a wider gap, as far as doubles tell
  std::optional<SumFacetEdges> edges{};  // where it is along one facet's normal that doubles found
};

/// Of bodies that are sums; radii have no part in it.
SumParting parted_sums(const Difference& d, Gap gap = Gap::likely);

/// The same of edges that are along the axes of space, one group each.
SumParting parted_along_axes(const EdgeSum& sum);

}  // namespace plumb::query::parting
