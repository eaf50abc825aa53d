// Branch and bound over posed boxes, as in closest_on_mesh.cpp; ties exactly.
#include "plumb/space/closest/posed_closest.hpp"

#include <algorithm>
#include <string>

#include "plumb/arith/exact_distance.hpp"
#include "plumb/space/bvh/descend_compact.hpp"
#include "query/body/figure_input.hpp"
#include "space/bvh/blocks.hpp"
#include "space/bvh/parts.hpp"
#include "space/closest/near_triangles.hpp"
#include "space/closest/posed_nearest_search.hpp"

namespace plumb {
namespace space {
namespace {

template <class Mesh>
std::optional<ClosestOnMesh> closest_posed(const PosedMeshOf<Mesh>& mesh, const Point3& p, double within = beyond_all) {
  const auto found = nearest_posed(mesh, p, 1, no_slot, Unwatched(), within);
  if (found.empty()) return {};
  return posed_found(mesh, p, found[0]);
}

template <class Mesh>
void require_posed(const char* function, const PosedMeshOf<Mesh>& mesh, const Point3& p) {
  require_pose(function, "mesh", mesh.pose);
  query::require_figure(function, "p", p);
}

template <class Mesh>
std::optional<ClosestOnMesh> closest_on_posed(const PosedMeshOf<Mesh>& mesh, const Point3& p, double within) {
  require_posed("closest_on_mesh", mesh, p);
  if (!is_reach("closest_on_mesh", within)) return {};
  return closest_posed(mesh, p, within);
}

template <class Mesh>
void closest_on_posed_of_each(const PosedMeshOf<Mesh>& mesh, std::span<const Point3> points,
                              std::span<ClosestOnMesh> out, const ClosestOptions& options) {
  if (points.size() != out.size()) {
    throw UnequalLengths("closest_on_mesh: points has length " + std::to_string(points.size()) + ", out has length " +
                         std::to_string(out.size()));
  }
  require_pose("closest_on_mesh", "mesh", mesh.pose);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!query::is_sound(points[i]))
      query::require_figure("closest_on_mesh", "points[" + std::to_string(i) + "]", points[i]);
  }
  if (points.empty()) return;
  if (mesh.bvh.slots() == 0) throw InvalidShape("closest_on_mesh: the mesh is empty; give one triangle at least");
  constexpr std::size_t part_size = 16;
  const std::size_t parts = blocks_of(points.size(), part_size);
  for_parts("closest_on_mesh", options.execution, options.progress, parts, [&](std::size_t part) {
    const std::size_t to = std::min(points.size(), (part + 1) * part_size);
    for (std::size_t i = part * part_size; i < to; ++i) out[i] = *closest_posed(mesh, points[i]);
  });
}

template <class Mesh>
std::vector<NearTriangle> posed_nearest(const PosedMeshOf<Mesh>& mesh, const Point3& p, std::size_t k,
                                        std::vector<NearTriangle> nearest) {
  nearest.clear();
  require_posed("nearest_triangles", mesh, p);
  for (const auto& c : nearest_posed(mesh, p, k)) nearest.push_back({c.item, c.distance});
  return nearest;
}

template <class Mesh>
std::vector<NearTriangle> posed_within(const PosedMeshOf<Mesh>& mesh, const Point3& p, double distance,
                                       std::vector<NearTriangle> within) {
  within.clear();
  require_posed("triangles_within", mesh, p);
  require_finite_distance(distance);
  if (distance < 0) return within;
  const Aabb3 point{p, p};
  const double limit = square_above_exact(distance);
  const auto enters = [&](const Aabb3& box) { return !(square_below(point, box) > limit); };
  descend(
      mesh.bvh.tree, [&](const BoxNode& node) { return enters(around(mesh, node)); },
      [&](std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t slot = first; slot < first + count; ++slot) {
          const PosedTriangle triangle = mesh.triangle(slot);
          if (!enters(around(triangle))) continue;
          const double d = query::distance(triangle, p);
          const auto exact = [&] { return ExactDistance{query::squared_distance_exact(triangle, p)}; };
          if (d < distance || (d == distance && compare(exact(), distance) != Sign::positive))
            within.push_back({mesh.bvh.number(slot), d});
        }
      });
  return each_once(std::move(within));
}

}  // namespace
}  // namespace space

// Each question of the mesh's tree in its usual and in its compact form.
#define PLUMB_POSED_CLOSEST(Mesh)                                                                      \
  std::optional<ClosestOnMesh> closest_on_mesh(const Mesh& mesh, const Point3& p, double within) {     \
    return space::closest_on_posed(mesh, p, within);                                                   \
  }                                                                                                    \
  void closest_on_mesh(const Mesh& mesh, std::span<const Point3> points, std::span<ClosestOnMesh> out, \
                       const ClosestOptions& options) {                                                \
    space::closest_on_posed_of_each(mesh, points, out, options);                                       \
  }                                                                                                    \
  std::vector<NearTriangle> nearest_triangles(const Mesh& mesh, const Point3& p, std::size_t k,        \
                                              std::vector<NearTriangle> rows) {                        \
    return space::posed_nearest(mesh, p, k, std::move(rows));                                          \
  }                                                                                                    \
  std::vector<NearTriangle> triangles_within(const Mesh& mesh, const Point3& p, double distance,       \
                                             std::vector<NearTriangle> rows) {                         \
    return space::posed_within(mesh, p, distance, std::move(rows));                                    \
  }
PLUMB_POSED_CLOSEST(PosedMesh)
PLUMB_POSED_CLOSEST(PosedCompactMesh)
#undef PLUMB_POSED_CLOSEST

}  // namespace plumb
