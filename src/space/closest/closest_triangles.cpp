#include "plumb/space/closest/closest_triangles.hpp"

#include "space/closest/closest_pair_search.hpp"

namespace plumb {

std::optional<ClosestTriangles> closest_triangles(const Bvh& a, const Bvh& b) {
  if (a.triangles.empty() || b.triangles.empty()) return {};
  return space::closest_pair_found(space::ClosestSearch<>(a, b).run());
}

}  // namespace plumb
