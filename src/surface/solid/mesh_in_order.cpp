#include "surface/solid/mesh_in_order.hpp"

#include <algorithm>

namespace plumb::surface {

ExactMesh mesh_in_order(std::vector<ExactPoint3> vertices,
                        std::vector<std::pair<TriangleMesh::Triangle, SourceFace>> triangles) {
  std::vector<std::uint32_t> number(vertices.size());
  for (auto& [corners, source] : triangles) {
    std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
    for (const std::uint32_t v : corners) number[v] = 1;
  }
  ExactMesh made;
  for (std::size_t v = 0; v < number.size(); ++v)
    if (std::exchange(number[v], static_cast<std::uint32_t>(made.vertices.size())) != 0)
      made.vertices.push_back(std::move(vertices[v]));
  std::ranges::sort(triangles);
  for (auto& [corners, source] : triangles) {
    for (std::uint32_t& v : corners) v = number[v];
    made.triangles.push_back(corners);
    made.sources.push_back(source);
  }
  return made;
}

}  // namespace plumb::surface
