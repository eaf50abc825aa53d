#include "plumb/surface/solid/arrangement.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "surface/solid/facet_list.hpp"
#include "surface/solid/joined_faces.hpp"

namespace plumb {
namespace {

using surface::FacePool, surface::FacetList, surface::PointTable, surface::SideSets;

/// The points that facets name, in lexicographic order; `rank` gets the number of each.
std::vector<ExactPoint3> ranked_vertices(const FacetList& list, const PointTable& table,
                                         std::vector<std::uint32_t>& rank) {
  std::vector<std::uint32_t> used;
  rank.assign(table.size(), 0);
  for (const auto& corners : list.facets)
    for (const std::uint32_t v : corners)
      if (std::exchange(rank[v], 1U) == 0) used.push_back(v);
  std::vector<ExactPoint3> points(table.size());
  for (const std::uint32_t v : used) points[v] = table.point(v);
  std::ranges::sort(
      used, [&](std::uint32_t l, std::uint32_t r) { return compare_xyz(points[l], points[r]) == Sign::negative; });
  std::vector<ExactPoint3> vertices;
  for (const std::uint32_t v : used) {
    rank[v] = static_cast<std::uint32_t>(vertices.size());
    vertices.push_back(std::move(points[v]));
  }
  return vertices;
}

void add_sources(const FacePool& pool, std::span<const surface::CoveringFace> covers, Arrangement& to) {
  const std::size_t first = to.sources.size();
  for (const surface::CoveringFace& by : covers)
    for (const FacetSource& use : pool.uses_of(by.face)) to.sources.push_back({use.face, by.opposite != use.opposite});
  std::sort(to.sources.begin() + static_cast<std::ptrdiff_t>(first), to.sources.end());
  to.first_source.push_back(static_cast<std::uint32_t>(to.sources.size()));
}

}  // namespace

Arrangement arrange(std::span<const TriangleMesh> meshes, Pieces pieces) {
  FacePool pool = surface::pool_faces(meshes);
  if (pieces == Pieces::of_polygons) pool = surface::join_coplanar_faces(std::move(pool));
  PointTable table(pool.mesh.vertices);
  const auto classes = surface::find_plane_classes(pool, table);
  const FacetList list = surface::divide_planes(pool, table, classes);
  const SideSets sets = surface::join_sides(list, table);
  Arrangement made;
  made.meshes = pool.meshes;
  const std::vector<std::int32_t> windings = surface::windings_of_sets(pool, list, table, sets);
  std::vector<std::uint32_t> rank;
  made.vertices = ranked_vertices(list, table, rank);
  std::vector<std::pair<TriangleMesh::Triangle, std::uint32_t>> facets;
  for (std::uint32_t f = 0; f < list.facets.size(); ++f) {
    auto corners = list.facets[f];
    for (std::uint32_t& v : corners) v = rank[v];
    std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
    facets.emplace_back(corners, f);
  }
  std::ranges::sort(facets);
  constexpr auto unnumbered = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> region(sets.count, unnumbered);
  const auto region_of = [&](std::uint32_t side) {
    std::uint32_t& number = region[sets.of[side]];
    if (number == unnumbered) {
      number = made.meshes == 0 ? 0 : static_cast<std::uint32_t>(made.windings.size() / made.meshes);
      const auto from = windings.begin() + std::ptrdiff_t{sets.of[side]} * made.meshes;
      made.windings.insert(made.windings.end(), from, from + made.meshes);
    }
    return number;
  };
  for (const auto& [corners, f] : facets) {
    made.facets.push_back(corners);
    const std::uint32_t over = region_of(surface::above(f));
    made.sides.push_back({over, region_of(surface::below(f))});
    add_sources(pool, list.covers_of(f), made);
  }
  return made;
}

}  // namespace plumb
