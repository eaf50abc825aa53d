// Closest features: how far apart are two features while they move, and when does that count?  Vertices, edges and a
// face.
//
// A pair says: where every bound is at least zero and the denominator is positive, the square of the distance of the
// figures is at most numerator / denominator, for that is the distance of two of their points.
// Laws: at every time the least distance of the figures is that of some pair that counts then: of the features whose
// insides hold the nearest points.  So the pairs of a triangle without area, or of parallel edges, are those of their
// vertices.
// Source: RTCD 5.1.2, 5.1.5, 5.1.9, 5.5.
// Cost: degree 2 for vertices, 4 for a vertex and an edge, 6 for the rest.
#pragma once

#include <vector>

#include "plumb/figure/containment/voronoi_region.hpp"
#include "query/time_of_impact/moving_vectors.hpp"

namespace plumb::query::moving {

/// p, a, b, c of a vertex against a triangle, or a, b, c, d of the edges ab and cd.
enum class MovingKind : unsigned char { vertex_triangle, edge_edge };
using FourMoving = std::array<MovingVector, 4>;

struct FeaturePair {
  arith::Polynomial numerator, denominator;
  arith::Polynomial zero;  // zero where the numerator is, of half its degree if there is one
  std::vector<arith::Polynomial> bounds;
  Feature a, b;
};

/// In order of the features: pairs of lower dimension first, then of lower numbers.  With `flat`, without the pair of
/// the triangle's face or of both edges.
std::vector<FeaturePair> feature_pairs(MovingKind kind, const FourMoving& points, bool flat);

}  // namespace plumb::query::moving
