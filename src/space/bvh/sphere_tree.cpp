#include "plumb/space/bvh/sphere_tree.hpp"

#include <cmath>
#include <string>

#include "plumb/figure/aabb/aabb.hpp"
#include "plumb/figure/sphere/fits.hpp"
#include "space/bvh/moved_ball.hpp"
#include "space/bvh/nested_spheres.hpp"
#include "space/bvh/octree_cells.hpp"
#include "space/bvh/pruned_cover.hpp"
#include "space/bvh/surface_pieces.hpp"

namespace plumb {
namespace space {
namespace {

constexpr std::uint32_t most_sphere_levels = 12;
constexpr int steps_a_level = 3;  // of a binary tree: up to eight children

/// Around the whole box.
Sphere3 sphere_of_box(const Aabb3& box) {
  std::vector<Point3> corners;
  add_corners(box, corners);
  return fit_sphere_box(corners);
}

/// Any spheres, gathered by a tree of boxes cut at the middle item.
SphereTree gathered(std::span<const Sphere3> spheres) {
  if (spheres.empty()) return {};
  std::vector<Aabb3> boxes;
  for (const Sphere3& s : spheres) boxes.push_back(fit_aabb(s));
  const BoxTree tree = build_box_tree(boxes, {.method = BvhMethod::object_median, .most_in_leaf = 1});
  const std::span<const BoxNode> nodes = tree.nodes.view();
  const auto is_leaf = [&](std::uint32_t i) { return nodes[i].is_leaf(); };
  std::vector<std::vector<std::uint32_t>> children;
  std::vector<std::uint32_t> now{0}, next;
  while (!std::ranges::all_of(now, is_leaf)) {
    std::vector<std::uint32_t>& counts = children.emplace_back();
    next.clear();
    for (const std::uint32_t node : now) {
      std::vector<std::uint32_t> below{node};
      for (int step = 0; step < steps_a_level; ++step) {
        std::vector<std::uint32_t> deeper;
        for (const std::uint32_t i : below) {
          if (is_leaf(i)) {
            deeper.push_back(i);
          } else {
            deeper.insert(deeper.end(), {i + 1, i + nodes[i].link});
          }
        }
        below.swap(deeper);
      }
      counts.push_back(static_cast<std::uint32_t>(below.size()));
      next.insert(next.end(), below.begin(), below.end());
    }
    now.swap(next);
  }
  if (std::ranges::any_of(now, [&](std::uint32_t i) { return nodes[i].count != 1; })) {  // too deep to be cut
    std::vector<std::uint32_t>& counts = children.emplace_back();
    for (const std::uint32_t i : now) counts.push_back(nodes[i].count);
  }
  std::vector<Sphere3> last;
  for (const std::uint32_t i : now) {
    for (std::uint32_t slot = nodes[i].link; slot < nodes[i].link + nodes[i].count; ++slot)
      last.push_back(spheres[tree.items[slot]]);
  }
  return nested_levels(children, last);
}

}  // namespace
}  // namespace space

SphereTree build_sphere_tree(const Bvh& mesh, const SphereTreeOptions& options) {
  const std::uint32_t levels = options.levels;
  if (levels < 1 || levels > space::most_sphere_levels)
    throw InvalidShape("build_sphere_tree: levels is " + std::to_string(levels) + "; give 1 to " +
                       std::to_string(space::most_sphere_levels));
  const space::OctreeCells cells = space::octree_cells(mesh, levels);
  std::vector<Sphere3> of_cells;
  for (const Aabb3& box : cells.least) of_cells.push_back(space::sphere_of_box(box));
  if (options.cover == SphereCover::octree) return space::nested_levels(cells.children, of_cells);
  const double radius = cells.side * std::sqrt(0.75);  // around a cell
  const int most_halvings = 4 * static_cast<int>(levels) + 4;
  if (options.cover == SphereCover::pieces)
    return space::gathered(space::covered_pieces(mesh, radius, most_halvings).spheres);
  for (Sphere3& s : of_cells) s.radius = std::max(s.radius, radius);
  return space::gathered(space::pruned_cover(space::covered_pieces(mesh, radius / 4, most_halvings), of_cells, radius));
}

SphereTree build_sphere_tree(const TriangleMesh& mesh, const SphereTreeOptions& options) {
  return build_sphere_tree(build_bvh(mesh, {.method = BvhMethod::linear}), options);
}

SphereTree transform(const SphereTree& tree, const MeshPose& pose) {
  space::require_pose("transform", "tree", pose);
  if (tree.nodes.empty()) return tree;
  const space::BallMover move("transform", pose);
  SphereTree moved = tree;
  for (SphereNode& node : moved.nodes) node.sphere = move(node.sphere);
  space::nest(moved);
  return moved;
}

}  // namespace plumb
