#include "surface/solid/mesh_in_order.hpp"

#include <algorithm>
#include <functional>

#include "surface/solid/sort_by_first.hpp"

namespace plumb::surface {
namespace {

/// take(v) gives vertex v away, or a copy of it; each is asked for once at most.
template <class Take>
ExactMesh mesh_of_taken(std::size_t vertices, const Take& take,
                        std::vector<std::pair<TriangleMesh::Triangle, SourceFace>> triangles) {
  std::vector<std::uint32_t> number(vertices);
  for (auto& [corners, source] : triangles) {
    std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
    for (const std::uint32_t v : corners) number[v] = 1;
  }
  ExactMesh made;
  made.vertices.reserve(static_cast<std::size_t>(std::ranges::count(number, 1U)));
  for (std::size_t v = 0; v < number.size(); ++v)
    if (std::exchange(number[v], static_cast<std::uint32_t>(made.vertices.size())) != 0)
      made.vertices.push_back(take(v));
  sort_by_first(
      triangles, number.size(), [](const auto& row) { return row.first[0]; }, std::less<>());
  made.triangles.reserve(triangles.size());
  made.sources.reserve(triangles.size());
  for (auto& [corners, source] : triangles) {
    for (std::uint32_t& v : corners) v = number[v];
    made.triangles.push_back(corners);
    made.sources.push_back(source);
  }
  return made;
}

}  // namespace

ExactMesh mesh_in_order(std::span<const ExactPoint3> vertices,
                        std::vector<std::pair<TriangleMesh::Triangle, SourceFace>> triangles) {
  const auto copy = [&](std::size_t v) -> const ExactPoint3& { return vertices[v]; };
  return mesh_of_taken(vertices.size(), copy, std::move(triangles));
}
ExactMesh mesh_in_order(std::vector<ExactPoint3>&& vertices,
                        std::vector<std::pair<TriangleMesh::Triangle, SourceFace>> triangles) {
  const auto take = [&](std::size_t v) -> ExactPoint3&& { return std::move(vertices[v]); };
  return mesh_of_taken(vertices.size(), take, std::move(triangles));
}

}  // namespace plumb::surface
