// Which features meet, of points that are in one plane?  The signs of their projections' sides tell.
//
// Laws: of a triangle abc and a point p the sides are those of pa pb, pb pc, pc pa; of edges ab and cd the triangles
// acd, bcd, abc, abd, the latter two as ac bc and ad bd.  `whole` is the sum of the former three, or acd less bcd; it
// is not zero.
// Source: RTCD 5.1.9, 5.4.2.
// Cost: comparisons.
#pragma once

#include <array>
#include <optional>

#include "plumb/figure/containment/voronoi_region.hpp"
#include "query/time_of_impact/feature_pairs.hpp"

namespace plumb::query::moving {

struct FeaturesInContact {
  Feature a, b;
};

inline FeaturesInContact triangle_features(const std::array<int, 4>& side) {
  std::uint32_t zeros = 0, edge = 0;
  for (std::uint32_t i = 0; i < 3; ++i) {
    if (side[i] == 0) ++zeros, edge = i;
  }
  const Feature point{FeatureKind::vertex, 0};
  if (zeros == 0) return {point, {FeatureKind::face, 0}};
  if (zeros == 1) return {point, {FeatureKind::edge, edge}};
  // Two edges of a triangle meet in the vertex that the later one starts with: ab, bc in b; bc, ca in c; ca, ab in a.
  const std::uint32_t vertex = side[2] != 0 ? 1 : side[0] != 0 ? 2 : 0;
  return {point, {FeatureKind::vertex, vertex}};
}

inline FeaturesInContact edge_features(const std::array<int, 4>& side) {
  const auto feature = [](int first, int second) {
    if (first == 0) return Feature{FeatureKind::vertex, 0};
    if (second == 0) return Feature{FeatureKind::vertex, 1};
    return Feature{FeatureKind::edge, 0};
  };
  return {feature(side[0], side[1]), feature(side[2], side[3])};
}

/// By the signs of the sides, and of the whole.
inline std::optional<FeaturesInContact> features_in_contact(MovingKind kind, const std::array<int, 4>& side,
                                                            int whole) {
  if (kind == MovingKind::vertex_triangle) {
    if (side[0] == -whole || side[1] == -whole || side[2] == -whole) return {};
    return triangle_features(side);
  }
  if (side[0] * side[1] > 0 || side[2] * side[3] > 0) return {};
  return edge_features(side);
}

}  // namespace plumb::query::moving
