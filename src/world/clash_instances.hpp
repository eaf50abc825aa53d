// Which parts are one shape in several places, and in which order are two parts named, whatever the order of all?
//
// Laws: (1) parts of one shape have the same triangles, and the same vertices when each is moved by its own origin; that
// is seen without rounding, or else the part is a shape of its own unless it is the same in the same place.  (2) The order
// of two parts depends on their meshes alone.
// Source: none.
// Cost: linear, and a comparison with each part of the same hash.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/figure/basic/mesh.hpp"

namespace plumb::world {

struct PlacedShape {
  std::uint32_t shape = 0;
  Point3 origin{};  // the first vertex, or zero where differences to that are not all doubles
};

std::vector<PlacedShape> placed_shapes(std::span<const TriangleMesh> parts);

/// Two shapes and how the second stands to the first: differences of their origins, and what these lose.
struct PlacedPair {
  std::uint32_t a, b;
  std::array<double, 6> offset;
  friend auto operator<=>(const PlacedPair&, const PlacedPair&) = default;
};
PlacedPair placed_pair(const PlacedShape& a, const PlacedShape& b);

/// Does the first come after the second?
bool comes_after(const TriangleMesh& a, const TriangleMesh& b);

}  // namespace plumb::world
