// In which order do rays that lie close together follow one another, and are they close enough to descend together?  By
// where they pass the middle of the mesh.
//
// Rays are given as somebody made them, an image row by row; sixteen of a square go by fewer nodes than of a row.
// Where many triangles lie between one and the next, sixteen have only few nodes in common, and take longer than one by
// one.
// Law: an order of all of them, which the answers do not depend on.
// Source: Morton 1966; RTCD 6.6.7, 7.3.5.
// Cost: some 10 ns a ray, a quotient and two passes of a sort by digits; nothing where the first ones go opposite ways.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/figure/basic/box.hpp"
#include "plumb/query/ray/ray.hpp"

namespace plumb::space {

struct RayOrder {
  std::vector<std::uint16_t> order;
  bool are_near = true;  // those that follow one another, or nothing is known of that
};

/// At most 65,536 rays, at so many triangles in a box, which is a guess.
RayOrder order_of(std::span<const AnyRay> rays, const Aabb3& box, std::size_t triangles);

}  // namespace plumb::space
