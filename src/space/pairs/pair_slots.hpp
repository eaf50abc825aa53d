// Do pairs name triangles?
#pragma once

#include <span>
#include <string>

#include "plumb/space/pairs/mesh_pairs.hpp"
#include "space/bvh/slot_triangles.hpp"

namespace plumb::space {

/// Throws InvalidShape for a number that names no triangle.
inline void require_pairs(std::span<const TrianglePair> pairs, std::size_t triangles_a, std::size_t triangles_b) {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto require = [&](const char* side, std::uint32_t item, std::size_t n) {
      if (item < n) return;
      throw InvalidShape("intersections: pairs[" + std::to_string(i) + "]." + side + " is " + std::to_string(item) +
                         ", but there are " + std::to_string(n) + " triangles");
    };
    require("a", pairs[i].a, triangles_a);
    require("b", pairs[i].b, triangles_b);
  }
}

}  // namespace plumb::space
