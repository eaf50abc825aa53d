// In which order do rays that lie close together follow one another?  By where they pass the middle of the mesh.
//
// Rays are given as somebody made them, an image row by row; sixteen of a square go by fewer nodes than of a row.
// Law: an order of all of them, which the answers do not depend on.
// Source: Morton 1966; RTCD 6.6.7, 7.3.5.
// Cost: some 10 ns a ray, a quotient and two passes of a sort by digits; nothing where the first ones go different ways.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/query/ray/ray.hpp"
#include "plumb/space/bvh/box_tree.hpp"

namespace plumb::space {

/// At most 65,536 rays.
std::vector<std::uint16_t> order_of(std::span<const AnyRay> rays, const FloatBox3& box, const BoxFrame& frame);

}  // namespace plumb::space
