// Are two meshes the same, but for the order of their vertices and triangles?
#pragma once

#include <algorithm>
#include <array>
#include <numeric>
#include <random>
#include <set>
#include <vector>

#include "figure/basic/solids.hpp"
#include "plumb/figure/basic/mesh.hpp"

namespace plumb::meshes_alike {

using Corner = std::array<double, 3>;
using Corners = std::array<Corner, 3>;

inline Corner corner_of(const Point3& p) { return {p.x + 0.0, p.y + 0.0, p.z + 0.0}; }

/// From the least point on.
inline Corners corners_of(const TriangleMesh& mesh, const TriangleMesh::Triangle& t) {
  const Corners c{corner_of(mesh.vertices[t[0]]), corner_of(mesh.vertices[t[1]]), corner_of(mesh.vertices[t[2]])};
  return std::min({c, Corners{c[1], c[2], c[0]}, Corners{c[2], c[0], c[1]}});
}

/// Triangles by their points: what no numbering changes.
inline std::multiset<Corners> triangles_of(const TriangleMesh& mesh) {
  std::multiset<Corners> all;
  for (const auto& t : mesh.triangles) all.insert(corners_of(mesh, t));
  return all;
}

/// Vertices and triangles in another order, triangles from another corner on.
inline TriangleMesh shuffled(const TriangleMesh& mesh, std::mt19937& random) {
  std::vector<std::uint32_t> order(mesh.vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::shuffle(order, random);
  TriangleMesh other{std::vector<Point3>(order.size()), mesh.triangles};
  for (std::size_t v = 0; v < order.size(); ++v) other.vertices[order[v]] = mesh.vertices[v];
  for (auto& t : other.triangles) {
    for (auto& v : t) v = order[v];
    std::rotate(t.begin(), t.begin() + random() % 3, t.end());
  }
  std::ranges::shuffle(other.triangles, random);
  return other;
}

/// A box whose faces are grids of n squares by n.
inline TriangleMesh grid_box(int n) {
  std::set<solids::Cell> cells;
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y)
      for (int z = 0; z < n; ++z) cells.insert({x, y, z});
  return solids::voxels(cells);
}

}  // namespace plumb::meshes_alike
