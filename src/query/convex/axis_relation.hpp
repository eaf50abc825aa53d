// Cylinders and cones against convex sets and balls: disjoint, touching or overlapping, exactly?
//
// Laws: those of query/overlap/overlap.hpp; the shape's radius is above zero and its ends differ.
// Method: what of a convex set lies between the planes of the shape's ends, seen along the axis of a cylinder, or from
// the apex of a cone onto the plane of its base, is a flat convex set again, which is as near to the axis as its nearest
// point.  So no point of a circle is ever asked for, and no root is taken.  From a ball's center the shape is one of its
// section, whose only root is the way to the axis.
// Source: RTCD 5.3.7; the perspective function of Boyd and Vandenberghe, Convex Optimization, 2.3.3.
// Cost: GMP; some 100 us.
#pragma once

#include "query/convex/posed_set.hpp"

namespace plumb::query {

Relation relate_axis_shape(const FlatSet& set, const RoundAxis& shape);
/// Chains of a polygon, which lie in one plane.
Relation relate_axis_shape(const ExactChains& chains, const RoundAxis& shape);
/// A ball by the square of its radius, which is above zero.
Relation relate_axis_shape(const Exact3& center, const mpq_class& squared_radius, const RoundAxis& shape);

}  // namespace plumb::query
