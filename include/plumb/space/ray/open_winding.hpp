// Generalized winding number, of meshes with holes: how often does the surface wind around a point, as a number that is
// none too whole where it is open?
//
//   const std::vector<BorderEdge> border = border_of(bvh);    // empty where the mesh is closed
//   const auto w = generalized_winding_number(bvh, border, p);
//   if (w && w->least > 0.5) ...                              // inside, for certain, of the usual threshold
//
// It is the solid angle that the triangles fill, seen from the point, over 4 pi; of a closed mesh winding_number
// (space/ray/inside.hpp).  It is counted along x, as that is, and what the border fills is added: of each of its edges
// what the strip from it against x to infinity would, where no ray along x leaves.
// Laws: (1) the exact number is from least to most; where the mesh is closed both are that whole number.  (2) There is none
// of a point on a triangle.  (3) A border is that of points, not of their numbers: edges that two triangles have in common
// are none, whichever vertices name them, and none is where triangles pass it as often either way.  (4) Of numbers beyond
// some 10^150 the interval may have all numbers that the border allows.
// A point that is NaN or infinite throws NonFinite.
// Source: RTCD 5.4.3; Jacobson, Kavan and Sorkine-Hornung 2013; Van Oosterom and Strackee 1983 for the angle.
// Cost: that of winding_number, and some microseconds for each edge of the border; the border sorts all edges.  Bounded by
// n log n comparisons, and n signs a point on integers as long as the exponents' span.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "plumb/space/bvh/bvh.hpp"

namespace plumb {

/// An edge that triangles pass more often this way than back, by so many times.
struct BorderEdge {
  Point3 from, to;
  std::int32_t times;
  friend bool operator==(const BorderEdge&, const BorderEdge&) = default;
};

std::vector<BorderEdge> border_of(const Bvh& mesh, std::vector<BorderEdge> rows = {});

struct WindingInterval {
  double least, most;
  friend bool operator==(const WindingInterval&, const WindingInterval&) = default;
};

/// The border must be that of the mesh.
std::optional<WindingInterval> generalized_winding_number(const Bvh& mesh, std::span<const BorderEdge> border,
                                                          const Point3& p);

}  // namespace plumb
