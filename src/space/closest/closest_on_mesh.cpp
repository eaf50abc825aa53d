// Branch and bound: boxes by squares that are rounded outward, triangles by distances, ties exactly.
#include "plumb/space/closest/closest_on_mesh.hpp"

#include <algorithm>

#include "figure/basic/finite_parts.hpp"
#include "query/body/figure_input.hpp"
#include "space/bvh/equal_lengths.hpp"
#include "space/bvh/mesh_source.hpp"
#include "space/bvh/parts.hpp"
#include "space/closest/near_triangles.hpp"
#include "space/closest/posed_nearest_search.hpp"

namespace plumb {
namespace {

template <class Source>
using NearestIn = space::Nearest<space::Unwatched, Source>;

// So many points are asked by one thread at a time; fewer under a pose, where each takes longer.
template <class Source>
constexpr std::size_t points_of_part = space::is_posed_source<Source> ? 16 : 64;

}  // namespace

std::optional<ClosestOnMesh> closest_on_mesh(const MeshView& mesh, const Point3& p, double within) {
  query::require_figure("closest_on_mesh", "p", p);
  return space::with_source("closest_on_mesh", "mesh", mesh,
                            [&]<class Source>(const Source& source) -> std::optional<ClosestOnMesh> {
                              if (!space::is_reach("closest_on_mesh", within)) return {};
                              NearestIn<Source> nearest(source, 1, {}, within);
                              const auto& found = nearest.of(p);
                              if (found.empty()) return {};
                              return space::closest_found(source, p, found[0]);
                            });
}

void closest_on_mesh(const MeshView& mesh, std::span<const Point3> points, std::span<ClosestOnMesh> out,
                     const ClosestOptions& options) {
  space::require_equal_lengths("closest_on_mesh", "points", points.size(), "out", out.size());
  figure::require_finite_points("closest_on_mesh", "points", points);
  space::with_source("closest_on_mesh", "mesh", mesh, [&]<class Source>(const Source& source) {
    if (points.empty()) return;
    if (space::mesh_of(source).slots() == 0)
      throw InvalidShape("closest_on_mesh: the mesh is empty; give one triangle at least");
    constexpr std::size_t part_size = points_of_part<Source>;
    const std::size_t parts = space::blocks_of(points.size(), part_size);
    space::for_parts("closest_on_mesh", options.execution, options.progress, parts, [&](std::size_t part) {
      NearestIn<Source> nearest(source, 1);
      const std::size_t to = std::min(points.size(), (part + 1) * part_size);
      for (std::size_t i = part * part_size; i < to; ++i)
        out[i] = space::closest_found(source, points[i], nearest.of(points[i])[0]);
    });
  });
}

std::vector<NearTriangle> nearest_triangles(const MeshView& mesh, const Point3& p, std::size_t k,
                                            std::vector<NearTriangle> rows) {
  rows.clear();
  query::require_figure("nearest_triangles", "p", p);
  space::with_source("nearest_triangles", "mesh", mesh, [&]<class Source>(const Source& source) {
    NearestIn<Source> nearest(source, k);
    for (const auto& c : nearest.of(p)) rows.push_back({c.item, c.distance});
  });
  return rows;
}

std::vector<NearTriangle> triangles_within(const MeshView& mesh, const Point3& p, double distance,
                                           std::vector<NearTriangle> rows) {
  rows.clear();
  query::require_figure("triangles_within", "p", p);
  space::with_source("triangles_within", "mesh", mesh, [&](const auto& source) {
    space::require_finite_distance(distance);
    if (distance < 0) return;
    space::each_within(source, p, distance, [&](std::uint32_t slot, double d) {
      rows.push_back({space::mesh_of(source).number(slot), d});
    });
  });
  return space::each_once(std::move(rows));
}

}  // namespace plumb
