// Which loops lie in one plane, one around others, so that a hole with islands is filled between them?
//
// Laws: (1) loops belong together where they lie exactly in one plane, and what they wind around once, in one piece, has
// several of them for its boundary.  Loops of a plane that cross, touch but in a vertex that both name, or wind around
// some place more often do not.  (2) The filling is the constrained Delaunay triangulation between the loops, whose edges it runs along as they
// do; it hangs on the points alone.
// Source: RTCD 12.3, 12.5.1.1.
// Cost: the plane of each loop against those of the others; n log n expected for loops that share a plane.  Bounded by
// n^2 signs.
#pragma once

#include "surface/repair/loop_filling.hpp"

namespace plumb::surface {

struct FilledIslands {
  std::vector<std::uint32_t> loops;  // numbers, ascending: two at least
  Filling filling;
};

std::vector<FilledIslands> island_fillings(std::span<const Point3> points,
                                           std::span<const std::vector<std::uint32_t>> loops);

}  // namespace plumb::surface
