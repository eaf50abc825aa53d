// Contact features: which vertex, edge or face of a body lies in a plane that touches it?
//
// Laws: of the dimension of what of the body lies in the plane, the feature of the lowest number that lies wholly in
// it, numbered as figure/containment/voronoi_region.hpp does, of round bodies as its surface; of a hull by its vertices
// alone the edge or face of the lowest vertex.
// Source: RTCD 9.5.3, 3.10.
// Cost: comparisons; a few signs where several corners lie in the plane.
#pragma once

#include <span>

#include "plumb/figure/containment/voronoi_region.hpp"
#include "query/penetration/edge_sum.hpp"
#include "query/penetration/way.hpp"

namespace plumb::query::parting {

/// `level`: all corners that lie in the plane, ascending.
Feature flush_feature(const BodyView& body, const CoreCorners& c, std::span<const std::uint32_t> level);

/// Of a body that is a sum of edges, some of which lie in the plane.  `is_plain`: they are independent.
Feature flush_feature(const BodyView& body, const CoreCorners& c, const SumLevel& level, bool is_plain);

/// Of both bodies, when the first has moved so that it touches the second, and a corner of each.
struct FlushPair {
  Feature a, b;
  Ends in_plane;
};
FlushPair flush_pair(const BodyView& a, const BodyView& b, const Difference& d, const Way& way);
/// Of all that is level of both, ascending.
FlushPair flush_pair(const BodyView& a, const BodyView& b, const Difference& d,
                     const std::array<std::span<const std::uint32_t>, 2>& level);

}  // namespace plumb::query::parting
