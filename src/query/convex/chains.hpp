// What is a polygon made of, in rationals?  Its vertices through its chains in turn, who follows whom, and its plane.
//
// Laws: exact; a polygon of the plane lies in z = 0.  `holds`: strictly inside, where the chains wind around an odd number
// of times and no chain passes.
// Source: RTCD 3.7.
// Cost: GMP, linear in the vertices.
#pragma once

#include <vector>

#include "query/convex/flat_set.hpp"
#include "query/convex/flat_view.hpp"

namespace plumb::query {

struct SpannedChains {
  std::vector<Exact3> vertices;
  std::vector<std::size_t> next;
  std::vector<std::size_t> span;  // vertices that span its plane: three, or as many as there are
};

SpannedChains chains_of(const FigureView& polygon);
/// As many of them, the first that will do, as span what all of them do.
std::vector<std::size_t> spanning(const std::vector<Exact3>& vertices);

/// For a point of the polygon's plane, of a polygon that spans one.
bool holds_inside(const SpannedChains& chains, const Exact3& p);

}  // namespace plumb::query
