#include "plumb/space/moving/moving_mesh.hpp"

#include <algorithm>
#include <string>

#include "figure/basic/finite_parts.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/space/bvh/refit.hpp"
#include "space/moving/swept_boxes.hpp"

namespace plumb {
namespace space {
namespace {

void require_as_many(const char* function, std::size_t to, std::size_t from) {
  if (to == from) return;
  throw UnequalLengths(std::string(function) + ": from has length " + std::to_string(from) + ", to has length " +
                       std::to_string(to));
}

void require_vertices(std::span<const Bvh::Corners> triangles, std::size_t vertices) {
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (triangles[t][k] < vertices) continue;
      throw InvalidShape("build_moving_mesh: triangles[" + std::to_string(t) + "][" + std::to_string(k) + "] is " +
                         std::to_string(triangles[t][k]) + ", but there are " + std::to_string(vertices) + " vertices");
    }
  }
}

template <class T>
void sort_out(std::vector<T>& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

std::vector<MovingMesh::Edge> edges_of(std::span<const Bvh::Corners> triangles) {
  std::vector<MovingMesh::Edge> edges;
  edges.reserve(3 * triangles.size());
  for (const auto& [a, b, c] : triangles) {
    for (const auto& [p, q] : {MovingMesh::Edge{a, b}, {b, c}, {c, a}}) {
      if (p != q) edges.push_back({std::min(p, q), std::max(p, q)});
    }
  }
  sort_out(edges);
  return edges;
}

std::vector<std::uint32_t> corners_of(std::span<const Bvh::Corners> triangles) {
  std::vector<std::uint32_t> corners;
  corners.reserve(3 * triangles.size());
  for (const Bvh::Corners& c : triangles) corners.insert(corners.end(), c.begin(), c.end());
  sort_out(corners);
  return corners;
}

template <class BoxOf>
std::vector<Aabb3> swept_boxes(const MovingMesh& mesh, Execution execution, std::size_t n, const BoxOf& box_of) {
  std::vector<Aabb3> boxes(n);
  for_blocks(execution, n, 1 << 14, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) boxes[i] = box_of(mesh, static_cast<std::uint32_t>(i));
  });
  return boxes;
}

/// of_tree(tree, boxes) for each of the three.
template <class OfTree>
void for_trees(MovingMesh& mesh, Execution execution, const OfTree& of_tree) {
  of_tree(mesh.corner_tree, swept_boxes(mesh, execution, mesh.corners.size(), swept_corner));
  of_tree(mesh.edge_tree, swept_boxes(mesh, execution, mesh.edges.size(), swept_edge));
  of_tree(mesh.triangle_tree, swept_boxes(mesh, execution, mesh.triangles.size(), swept_triangle));
}

}  // namespace
}  // namespace space

MovingMesh build_moving_mesh(std::span<const Point3> from, std::span<const Point3> to,
                             std::span<const Bvh::Corners> triangles, const BvhOptions& options) {
  space::require_as_many("build_moving_mesh", to.size(), from.size());
  figure::require_finite_points("build_moving_mesh", "from", from);
  figure::require_finite_points("build_moving_mesh", "to", to);
  space::require_vertices(triangles, from.size());
  space::check_options("build_moving_mesh", options);
  MovingMesh mesh;
  mesh.from.assign(from.begin(), from.end());
  mesh.to.assign(to.begin(), to.end());
  mesh.triangles.assign(triangles.begin(), triangles.end());
  mesh.edges = space::edges_of(triangles);
  mesh.corners = space::corners_of(triangles);
  space::for_trees(mesh, options.execution,
                   [&](BoxTree& tree, const std::vector<Aabb3>& boxes) { tree = build_box_tree(boxes, options); });
  return mesh;
}

void next_frame(MovingMesh& mesh, std::span<const Point3> to, Execution execution) {
  space::require_as_many("next_frame", to.size(), mesh.from.size());
  figure::require_finite_points("next_frame", "to", to);
  mesh.from.swap(mesh.to);
  mesh.to.assign(to.begin(), to.end());
  space::for_trees(mesh, execution,
                   [&](BoxTree& tree, const std::vector<Aabb3>& boxes) { refit(tree, boxes, execution); });
}

}  // namespace plumb
