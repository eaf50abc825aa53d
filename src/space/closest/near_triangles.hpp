// Which triangles are within a distance, told as they are asked for: of distances that are numbers, each triangle once.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "plumb/arith/error.hpp"
#include "plumb/space/closest/closest_on_mesh.hpp"

namespace plumb::space {

inline void require_finite_distance(double distance) {
  if (!(distance - distance == 0)) {
    throw NonFinite("triangles_within: distance is " + std::to_string(distance) + ", but it must be finite");
  }
}

/// May anything be within it?  Nothing is within a negative distance, all within an infinite one.
inline bool is_reach(const char* function, double within) {
  if (within != within)
    throw NonFinite(std::string(function) + ": within is nan, not a real number; give one, or infinity");
  return within >= 0;
}

/// In order of their numbers; an item of a tree may be in several slots.
inline std::vector<NearTriangle> each_once(std::vector<NearTriangle> within) {
  std::ranges::sort(within, {}, &NearTriangle::triangle);
  const auto is_same = [](const NearTriangle& x, const NearTriangle& y) { return x.triangle == y.triangle; };
  within.erase(std::unique(within.begin(), within.end(), is_same), within.end());
  return within;
}

}  // namespace plumb::space
