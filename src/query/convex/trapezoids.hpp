// Decomposition into convex pieces: which trapezoids make up what the chains of a polygon wind around an odd number of
// times?
//
// Laws: exact; the trapezoids, closed, are the closure of the inside, and their relative interiors are apart.  Any
// chains in one plane will do; where they have no area there are none.
// Method: between neighboring places of vertices and crossings edges do not cross; from below, every second gap between
// them is inside.
// Source: RTCD 12.5; the slabs of Dobkin and Lipton 1976.
// Cost: GMP; quadratic in the edges, and times them for each slab.
#pragma once

#include <optional>
#include <vector>

#include "query/convex/flat_set.hpp"

namespace plumb::query {

/// The last vertex of each is joined to the first; all lie in one plane.
using ExactChains = std::vector<std::vector<Exact3>>;

/// Of the plane that they span; nothing where they lie on one line.
std::optional<Exact3> normal_of(const ExactChains& chains);

std::vector<FlatSet> trapezoids(const ExactChains& chains);

/// The edges, as sets: all that is on the chains.
std::vector<FlatSet> edges_of(const ExactChains& chains);

/// A convex set with its relative interior, or without: a point beside others on one line.
struct LinePiece {
  FlatSet set;
  bool has_inside;
};
/// The union of the edges of chains on one line.
std::vector<LinePiece> pieces_on_line(const ExactChains& chains);

}  // namespace plumb::query
