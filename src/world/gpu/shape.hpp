// What is drawn of a body?  Triangles whose corners are boxes that hold the exact ones.
//
// Laws: of a surface, the hulls of its faces' corners hold all of it, and those of its edges all edges; of any other
// body the lines along each axis through each of its points meet such a hull on both sides of the point, or at it.
// Source: RTCD 10.2, 10.3.
// Cost: a box for each corner.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "plumb/figure/basic/box.hpp"
#include "plumb/world/any_body.hpp"
#include "world/placed.hpp"

namespace plumb::world {

struct DrawnShape {
  Aabb3 box{};  // around all of it
  bool is_surface = true;
  std::vector<Aabb3> corners;
  std::vector<std::array<std::uint32_t, 3>> faces;
  std::vector<std::array<std::uint32_t, 2>> edges;  // of a surface
};

std::vector<Placed> placed_parts(const AnyBody& body);
/// A compound of which one part is no surface is none.
DrawnShape drawn_shape(const std::vector<Placed>& parts);

}  // namespace plumb::world
