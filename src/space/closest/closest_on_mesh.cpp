// Branch and bound: boxes by squares that are rounded outward, triangles by distances, ties exactly.
#include "plumb/space/closest/closest_on_mesh.hpp"

#include <algorithm>

#include "figure/basic/finite_parts.hpp"
#include "query/body/figure_input.hpp"
#include "space/bvh/equal_lengths.hpp"
#include "space/bvh/parts.hpp"
#include "space/closest/near_triangles.hpp"
#include "space/closest/nearest_search.hpp"

namespace plumb {
namespace space {
namespace {

template <class Mesh>
using NearestIn = Nearest<Unwatched, Mesh>;

template <class Mesh>
std::optional<ClosestOnMesh> closest_of(const Mesh& mesh, const Point3& p, double within) {
  query::require_figure("closest_on_mesh", "p", p);
  if (!is_reach("closest_on_mesh", within)) return {};
  const auto found = NearestIn<Mesh>(mesh, 1, {}, within).of(p);
  if (found.empty()) return {};
  return closest_found(mesh, p, found[0]);
}

template <class Mesh>
void closest_of_each(const Mesh& mesh, std::span<const Point3> points, std::span<ClosestOnMesh> out,
                     const ClosestOptions& options) {
  require_equal_lengths("closest_on_mesh", "points", points.size(), "out", out.size());
  figure::require_finite_points("closest_on_mesh", "points", points);
  if (points.empty()) return;
  if (mesh.tree.nodes.empty()) throw InvalidShape("closest_on_mesh: the mesh is empty; give one triangle at least");
  constexpr std::size_t part_size = 64;
  const std::size_t parts = blocks_of(points.size(), part_size);
  for_parts("closest_on_mesh", options.execution, options.progress, parts, [&](std::size_t part) {
    NearestIn<Mesh> nearest(mesh, 1);
    const std::size_t to = std::min(points.size(), (part + 1) * part_size);
    for (std::size_t i = part * part_size; i < to; ++i) {
      out[i] = closest_found(mesh, points[i], nearest.of(points[i])[0]);
    }
  });
}

template <class Mesh>
std::vector<NearTriangle> nearest_of(const Mesh& mesh, const Point3& p, std::size_t k,
                                     std::vector<NearTriangle> nearest) {
  nearest.clear();
  query::require_figure("nearest_triangles", "p", p);
  NearestIn<Mesh> search(mesh, k);
  for (const auto& c : search.of(p)) nearest.push_back({c.item, c.distance});
  return nearest;
}

template <class Mesh>
std::vector<NearTriangle> found_within(const Mesh& mesh, const Point3& p, double distance,
                                       std::vector<NearTriangle> within) {
  within.clear();
  query::require_figure("triangles_within", "p", p);
  require_finite_distance(distance);
  if (distance < 0) return within;
  const SlotTriangles triangles(mesh);
  each_within(mesh, triangles, p, distance, [&](std::uint32_t slot, double d) {
    within.push_back({triangles.number(slot), d});
  });
  return each_once(std::move(within));
}

}  // namespace
}  // namespace space

std::optional<ClosestOnMesh> closest_on_mesh(const Bvh& mesh, const Point3& p, double within) {
  return space::closest_of(mesh, p, within);
}
std::optional<ClosestOnMesh> closest_on_mesh(const CompactBvh& mesh, const Point3& p, double within) {
  return space::closest_of(mesh, p, within);
}

void closest_on_mesh(const Bvh& mesh, std::span<const Point3> points, std::span<ClosestOnMesh> out,
                     const ClosestOptions& options) {
  space::closest_of_each(mesh, points, out, options);
}
void closest_on_mesh(const CompactBvh& mesh, std::span<const Point3> points, std::span<ClosestOnMesh> out,
                     const ClosestOptions& options) {
  space::closest_of_each(mesh, points, out, options);
}

std::vector<NearTriangle> nearest_triangles(const Bvh& mesh, const Point3& p, std::size_t k,
                                            std::vector<NearTriangle> rows) {
  return space::nearest_of(mesh, p, k, std::move(rows));
}
std::vector<NearTriangle> nearest_triangles(const CompactBvh& mesh, const Point3& p, std::size_t k,
                                            std::vector<NearTriangle> rows) {
  return space::nearest_of(mesh, p, k, std::move(rows));
}

std::vector<NearTriangle> triangles_within(const Bvh& mesh, const Point3& p, double distance,
                                           std::vector<NearTriangle> rows) {
  return space::found_within(mesh, p, distance, std::move(rows));
}
std::vector<NearTriangle> triangles_within(const CompactBvh& mesh, const Point3& p, double distance,
                                           std::vector<NearTriangle> rows) {
  return space::found_within(mesh, p, distance, std::move(rows));
}

}  // namespace plumb
