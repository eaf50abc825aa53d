// Closest features: which features of a triangle and another straight shape come closest?  A guess in doubles, and its
// proof.
//
// Laws: an answer is proved by signs that are certain: the closest points of the two features lie strictly within them,
// and all else of either shape lies strictly beyond its end of the line between them; so there is no other closest
// pair.  Of triangles that cross, both ends of their intersection are proved, and the first of them is named.  Where a
// sign is not certain, or zero, there is no answer.
// Source: Larsen, Gottschalk, Lin and Manocha 1999 (two edges whose third corners lie on the outside are closest); the
// conditions are those of convex optimization.
// Cost: that of the same search in doubles, and 20 ns for the proof.
#pragma once

#include <optional>

#include "plumb/figure/basic/simplex.hpp"
#include "plumb/figure/containment/voronoi_region.hpp"
#include "query/closest/linear_pair.hpp"

namespace plumb::query {

struct FeaturePair {
  Feature a, b;
};

std::optional<FeaturePair> certain_features(const Straight<Point3>& a, const Triangle3& b);
std::optional<FeaturePair> certain_features(const Triangle3& a, const Triangle3& b);

}  // namespace plumb::query
