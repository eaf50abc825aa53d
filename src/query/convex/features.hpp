// Closest features: which vertex, edge or face of a figure holds this point of it?  Of a point that no doubles need
// hold.
//
// Laws: the feature of the lowest dimension and then of the lowest number that holds the point, as
// query/body/boundary.hpp numbers them; of a round figure that of its core at the core's point, numbered as its
// surface, or the interior.  Of a k-DOP and of an intersection of halfspaces only sides are features: 2 times the
// direction, plus 1 at its upper end; the number of the halfspace.  Under a map a feature is the image of what it is
// without it.
// Source: figure/containment/voronoi_region.hpp.
// Cost: a few rational comparisons a feature; some 10 us for each whose box holds the point.
#pragma once

#include <span>

#include "plumb/figure/containment/voronoi_region.hpp"
#include "query/convex/exact_map.hpp"
#include "query/convex/flat_view.hpp"

namespace plumb::query {

/// Of a point of the figure, or of its core where it is round, under the map or not.  `is_inside`: strictly inside the
/// round figure.
Feature feature_at(const FigureView& figure, const Exact3& point, bool is_inside, const ExactMap* map = nullptr);

/// Is p in the hull of those corners?
bool hull_holds(std::span<const Exact3> corners, std::span<const std::uint32_t> of, const Exact3& p);

/// A feature of the core as one of the figure, on its surface where it is round.
Feature on_surface(const FigureView& figure, const Feature& core);

}  // namespace plumb::query
