// Minkowski difference: which few pairs of vertices prove where the origin lies in it?
//
// The difference is all points of a less all points of b, of the hulls of their vertices.  Its point nearest to the
// origin is a sum of at most four pairs; where that is the origin itself, either its relative interior holds it, which
// pairs that span the difference prove, or a plane does that has all of it on one side.
// Laws: exact, and the searches end; weights are above zero, of sum 1.
// Source: Wolfe 1976; Gilbert, Johnson and Keerthi 1988; Rockafellar 1970, theorems 6.4 and 11.3.
// Cost: GMP; some 10 us; where the origin is on an edge or a face of what is found some 100 us, linear in the vertices.
#pragma once

#include <optional>

#include "plumb/query/certificate/certificate.hpp"
#include "query/convex/flat_set.hpp"
#include "query/separation/corners.hpp"

namespace plumb::query {

/// The sum of the pairs, u - v each, nearest to the origin.
struct NearestDifference {
  std::vector<WeightedPair> pairs;
  Exact3 at;
  mpq_class square;
};
NearestDifference nearest_difference(const CoreCorners& a, const CoreCorners& b);

/// Where the difference holds the origin, and the pairs make it: more pairs that span the difference with them, or the
/// direction of a plane through the origin that holds part of it and has the rest on one side.
struct SpanOrPlane {
  std::vector<WeightedPair> pairs;
  std::optional<Exact3> normal;  // instead
};
SpanOrPlane span_or_plane(const CoreCorners& a, const CoreCorners& b, std::vector<WeightedPair> pairs);

}  // namespace plumb::query
