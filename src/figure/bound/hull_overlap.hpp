// GJK, separating plane: do the convex hulls of two sets of points meet?  Exactly, by a proposal in doubles that exact
// signs prove.
//
// Laws: (1) the answer of real arithmetic for the closed hulls.  (2) Either a direction in which all of one set lies
// beyond all of the other proves that they are apart, or a tetrahedron of differences around the origin that they meet;
// where the search finds neither, a linear program in rationals decides.
// Method: the simplex nearest to the origin, grown by support points (Gilbert, Johnson and Keerthi 1988; RTCD 9.5).
// Cost: some passes over the points, 1 to 2 ns a point each; milliseconds where hulls touch.
#pragma once

#include <span>

#include "plumb/arith/point.hpp"

namespace plumb::figure {

bool hulls_meet(std::span<const Point3> a, std::span<const Point3> b);

}  // namespace plumb::figure
