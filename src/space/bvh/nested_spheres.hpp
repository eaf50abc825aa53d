// From the levels of a hierarchy and the spheres of its last one to a sphere tree: the others around their children.
#pragma once

#include <algorithm>
#include <span>

#include "figure/basic/finite_parts.hpp"
#include "figure/sphere/ball_reach.hpp"
#include "plumb/space/bvh/sphere_tree.hpp"

namespace plumb::space {

/// Around all balls: a center guessed in doubles, which moves toward the ball that reaches farthest (Badoiu and Clarkson
/// 2003), and the least radius that holds them from there.
Sphere3 sphere_around(std::span<const Sphere3> balls);

/// children[k]: how many each node of level k has; none for the last level.
SphereTree nested_levels(const std::vector<std::vector<std::uint32_t>>& children, std::span<const Sphere3> last);

/// Makes spheres contain their children's, where they do not.
void nest(SphereTree& tree);

}  // namespace plumb::space
