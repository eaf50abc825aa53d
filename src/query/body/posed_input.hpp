// Are these figures and their poses ones at all?  One answer for all questions about posed figures.
//
// Laws: those of query/body/figure_input.hpp; the parts of a posed figure are named as its members are: "relate:
// triangle.shape.b.y is nan", "relate: triangle.pose.columns[1].x is nan".
// Cost: an addition a number.
#pragma once

#include "plumb/query/body/posed.hpp"

namespace plumb::query {

/// What a pose may be given instead that leaves nothing as round as it is.
inline constexpr std::string_view rigid_instead = "give a RigidPose, whose turn nearest_rotation makes of a matrix";

void require_posed(std::string_view function, std::string_view name, const PosedView& figure);
void require_posed(std::string_view function, const PosedView& a, const PosedView& b);

}  // namespace plumb::query
