// Minkowski sum: which of the edges that leave a vertex are extreme, and in what order do they follow one another?
//
// Laws: the cone of the edges is pointed: all of them point up along some direction.  Of the extreme ones each, the
// next and any third have a positive triple product, so that a face of the cone lies between each and the next;
// parallel edges are merged into one that has both ends.
// Cost: k log k signs of degree 3 for k edges, some of degree 2.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "plumb/arith/point.hpp"

namespace plumb::figure::minkowski {

/// From a vertex of one of two bodies to a neighbor; or of both, in parallel.
struct Edge {
  Point3 from, to;
  std::optional<std::uint32_t> to_a, to_b;
};

using Cone = std::vector<Edge>;

/// `extreme`: the number of an edge that is known to be extreme, with which the cone then begins.  Without it all edges
/// must ascend in the lexicographic order.
Cone cone(const std::vector<Edge>& edges, std::optional<std::size_t> extreme = {});

/// Of edges that are not parallel: counterclockwise in the first of the planes xy, yz, zx in which they turn at all.
bool turns_left(const Edge& a, const Edge& b);

}  // namespace plumb::figure::minkowski
