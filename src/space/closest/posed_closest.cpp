// Branch and bound over posed boxes, as in closest_on_mesh.cpp and closest_triangles.cpp; ties exactly.
#include "plumb/space/closest/posed_closest.hpp"

#include <algorithm>
#include <string>

#include "plumb/arith/exact_distance.hpp"
#include "query/body/figure_input.hpp"
#include "space/bvh/parts.hpp"
#include "space/closest/posed_closest_search.hpp"

namespace plumb {
namespace space {
namespace {

std::optional<ClosestOnMesh> closest_posed(const PosedMesh& mesh, const Point3& p) {
  const auto found = nearest_posed(mesh, p, 1);
  if (found.empty()) return {};
  return posed_found(mesh, p, found[0]);
}

void require_posed(const char* function, const PosedMesh& mesh, const Point3& p) {
  require_pose(function, "mesh", mesh.pose);
  query::require_figure(function, "p", p);
}

}  // namespace
}  // namespace space

std::optional<ClosestOnMesh> closest_on_mesh(const PosedMesh& mesh, const Point3& p) {
  space::require_posed("closest_on_mesh", mesh, p);
  return space::closest_posed(mesh, p);
}

void closest_on_mesh(const PosedMesh& mesh, std::span<const Point3> points, std::span<ClosestOnMesh> out,
                     const ClosestOptions& options) {
  if (points.size() != out.size()) {
    throw UnequalLengths("closest_on_mesh: points has length " + std::to_string(points.size()) + ", out has length " +
                         std::to_string(out.size()));
  }
  space::require_pose("closest_on_mesh", "mesh", mesh.pose);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!query::is_sound(points[i]))
      query::require_figure("closest_on_mesh", "points[" + std::to_string(i) + "]", points[i]);
  }
  if (points.empty()) return;
  if (mesh.bvh.triangles.empty()) throw InvalidShape("closest_on_mesh: the mesh is empty; give one triangle at least");
  constexpr std::size_t part_size = 16;
  const std::size_t parts = space::blocks_of(points.size(), part_size);
  space::for_parts("closest_on_mesh", options.execution, options.progress, parts, [&](std::size_t part) {
    const std::size_t to = std::min(points.size(), (part + 1) * part_size);
    for (std::size_t i = part * part_size; i < to; ++i) out[i] = *space::closest_posed(mesh, points[i]);
  });
}

std::vector<NearTriangle> nearest_triangles(const PosedMesh& mesh, const Point3& p, std::size_t k) {
  space::require_posed("nearest_triangles", mesh, p);
  std::vector<NearTriangle> nearest;
  for (const auto& c : space::nearest_posed(mesh, p, k)) nearest.push_back({c.item, c.distance});
  return nearest;
}

std::vector<NearTriangle> triangles_within(const PosedMesh& mesh, const Point3& p, double distance) {
  space::require_posed("triangles_within", mesh, p);
  if (!(distance - distance == 0)) {
    throw NonFinite("triangles_within: distance is " + std::to_string(distance) + ", but it must be finite");
  }
  std::vector<NearTriangle> within;
  if (distance < 0) return within;
  const Aabb3 point{p, p};
  const double limit = space::square_above_exact(distance);
  const auto enters = [&](const Aabb3& box) { return !(space::square_below(point, box) > limit); };
  descend(
      mesh.bvh.tree, [&](const BoxNode& node) { return enters(space::around(mesh, node)); },
      [&](std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t slot = first; slot < first + count; ++slot) {
          const Posed<Triangle3> triangle = mesh.triangle(slot);
          if (!enters(space::around(triangle))) continue;
          const double d = query::distance(triangle, p);
          const auto exact = [&] { return ExactDistance{query::squared_distance_exact(triangle, p)}; };
          if (d < distance || (d == distance && compare(exact(), distance) != Sign::positive))
            within.push_back({mesh.bvh.tree.items[slot], d});
        }
      });
  std::ranges::sort(within, {}, &NearTriangle::triangle);
  // An item may be in several slots.
  const auto is_same = [](const NearTriangle& x, const NearTriangle& y) { return x.triangle == y.triangle; };
  within.erase(std::unique(within.begin(), within.end(), is_same), within.end());
  return within;
}

std::optional<ClosestTriangles> closest_triangles(const PosedMesh& a, const PosedMesh& b) {
  space::require_pose("closest_triangles", "a", a.pose);
  space::require_pose("closest_triangles", "b", b.pose);
  if (a.bvh.triangles.empty() || b.bvh.triangles.empty()) return {};
  return space::posed_pair_found(a, b, space::PosedClosestSearch<>(a, b).run());
}

}  // namespace plumb
