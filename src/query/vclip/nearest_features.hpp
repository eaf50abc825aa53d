// Closest features: between which corners of two features is the least way, and does no other corner lie before it?
//
// Laws: `corners` are independent and their nearest point needs all of them; nothing where the features' nearest points
// are not inside of them.  `holds`: no corner of either solid lies before the plane through its point, at right angles
// to the way.
// Source: query/separation/nearest_corners.hpp.
// Cost: some 10 signs, and one for each neighbor of a corner of each feature.
#pragma once

#include "query/separation/nearest_corners.hpp"
#include "query/vclip/walk.hpp"

namespace plumb::query::vclipping {

/// An edge instead of its face where that has the nearest point to a vertex on it.
MeshFeaturePair without_bounded_faces(const Solid& a, const Solid& b, MeshFeaturePair at, CheckedSigns& sign);

std::optional<DifferenceCorners> corners_of_features(const Solid& a, const Solid& b, const MeshFeaturePair& at,
                                                     CheckedSigns& sign);

struct FeaturesProved {
  bool holds = false, meet = false;
};
FeaturesProved prove_features(const Solid& a, const Solid& b, const MeshFeaturePair& at,
                              const DifferenceCorners& corners);

}  // namespace plumb::query::vclipping
