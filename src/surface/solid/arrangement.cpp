#include "plumb/surface/solid/arrangement.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

#include "plumb/space/bvh/build.hpp"
#include "surface/solid/arranged.hpp"
#include "surface/solid/facet_list.hpp"
#include "surface/solid/joined_faces.hpp"
#include "surface/solid/sort_by_first.hpp"

namespace plumb {
namespace {

using surface::FacePool, surface::FacetList, surface::NumberedPoints, surface::PointTable, surface::SideSets;

/// The points that facets name, in lexicographic order; `rank` gets the number of each.  Those as given are in order.
std::vector<ExactPoint3> ranked_vertices(const FacetList& list, PointTable&& table, std::vector<std::uint32_t>& rank) {
  std::vector<std::uint8_t> is_used(table.size());
  for (const auto& corners : list.facets)
    for (const std::uint32_t v : corners) is_used[v] = 1;
  struct Constructed {
    std::uint32_t number, given_before;
  };
  const NumberedPoints points = table.points();
  std::vector<Constructed> constructed;
  std::size_t count = 0;
  for (std::uint32_t v = 0; v < is_used.size(); ++v) {
    count += is_used[v];
    if (is_used[v] == 0 || table.is_given(v)) continue;
    constructed.push_back({v, table.given_before(points.at(v))});
  }
  std::ranges::sort(constructed, [&](const Constructed& l, const Constructed& r) {
    return l.given_before != r.given_before ? l.given_before < r.given_before
                                            : points.order(l.number, r.number) == Sign::negative;
  });
  const std::size_t given = points.given.size();
  std::vector<ExactPoint3> made = std::move(table).take_made();
  std::vector<ExactPoint3> vertices;
  vertices.reserve(count);
  rank.assign(is_used.size(), 0);
  auto next = constructed.begin();
  for (std::uint32_t v = 0;; ++v) {
    for (; next != constructed.end() && next->given_before == v; ++next) {
      rank[next->number] = static_cast<std::uint32_t>(vertices.size());
      vertices.push_back(std::move(made[next->number - given]));
    }
    if (v == given) return vertices;
    if (is_used[v] == 0) continue;
    rank[v] = static_cast<std::uint32_t>(vertices.size());
    vertices.emplace_back(points.given[v]);
  }
}

void add_sources(const FacePool& pool, std::span<const surface::CoveringFace> covers, Arrangement& to) {
  const std::size_t first = to.sources.size();
  for (const surface::CoveringFace& by : covers)
    for (const FacetSource& use : pool.uses_of(by.face)) to.sources.push_back({use.face, by.opposite != use.opposite});
  std::sort(to.sources.begin() + static_cast<std::ptrdiff_t>(first), to.sources.end());
  to.first_source.push_back(static_cast<std::uint32_t>(to.sources.size()));
}

}  // namespace

Arrangement surface::arranged(FacePool pool, Pieces pieces) {
  if (pieces == Pieces::of_polygons) pool = surface::join_coplanar_faces(std::move(pool));
  const Bvh bvh = build_bvh(pool.mesh, {.method = BvhMethod::linear});  // which is asked once
  PointTable table(pool.points());
  const FacetList list = surface::divide_planes(pool, table, surface::find_plane_classes(pool, bvh, table));
  const SideSets sets = surface::join_sides(list, table);
  Arrangement made;
  made.meshes = pool.meshes;
  const std::vector<std::int32_t> windings = surface::windings_of_sets(pool, bvh, list, table, sets);
  std::vector<std::uint32_t> rank;
  made.vertices = ranked_vertices(list, std::move(table), rank);
  std::vector<std::pair<TriangleMesh::Triangle, std::uint32_t>> facets;
  facets.reserve(list.facets.size());
  for (std::uint32_t f = 0; f < list.facets.size(); ++f) {
    auto corners = list.facets[f];
    for (std::uint32_t& v : corners) v = rank[v];
    std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
    facets.emplace_back(corners, f);
  }
  surface::sort_by_first(
      facets, made.vertices.size(), [](const auto& row) { return row.first[0]; }, std::less<>());
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
  made.facets.reserve(facets.size());
  made.sides.reserve(facets.size());
  for (const auto& [corners, f] : facets) {
    made.facets.push_back(corners);
    const std::uint32_t over = region_of(surface::above(f));
    made.sides.push_back({over, region_of(surface::below(f))});
    add_sources(pool, list.covers_of(f), made);
  }
  return made;
}

Arrangement arrange(std::span<const TriangleMesh> meshes, Pieces pieces) {
  return surface::arranged(surface::pool_faces(meshes), pieces);
}
Arrangement arrange(std::span<const TriangleMesh> solids, std::span<const TriangleMesh> sheets) {
  std::vector<const TriangleMesh*> all = surface::each_of(solids);
  for (const TriangleMesh& sheet : sheets) all.push_back(&sheet);
  return surface::arranged(surface::pool_faces(all, static_cast<std::uint32_t>(sheets.size())), Pieces::of_triangles);
}
Arrangement arrange(std::span<const ExactMesh> meshes, Pieces pieces) {
  return surface::arranged(surface::pool_faces(surface::each_of(meshes)), pieces);
}

}  // namespace plumb
