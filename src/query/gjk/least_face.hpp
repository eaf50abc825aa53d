// Which face of a hull holds a point, and no smaller one does?
//
// Laws: exact; the face is told by its dimension and the lowest number of a given point that is in it.
// Method: a point is in the least face that holds x where x is a sum of points in which it has weight: the linear program
// finds as many such points at once as there are.
// Source: Chvatal, Linear Programming, 1983, chapter 10.
// Cost: a rational linear program of twice as many rows as points: milliseconds for tens of points.
#pragma once

#include "plumb/figure/containment/voronoi_region.hpp"
#include "query/convex/flat_set.hpp"

namespace plumb::query {

/// Of a point of the hull, none of which is beyond it along `way`: points that are less far are in no face with it.  All of
/// them are asked where that leads nowhere.
Feature least_face(const std::vector<Exact3>& points, const Exact3& x, const Exact3& way);

/// Of the flat that the points span.
int dimension_of(const std::vector<Exact3>& points);

}  // namespace plumb::query
