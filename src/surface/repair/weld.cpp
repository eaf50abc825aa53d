#include "plumb/surface/repair/weld.hpp"

#include <algorithm>

#include "figure/basic/mesh_input.hpp"
#include "plumb/certify/compare_distance.hpp"
#include "plumb/figure/basic/equal_points.hpp"
#include "plumb/space/kd_tree/point_range.hpp"
#include "plumb/surface/topology/topology.hpp"
#include "surface/repair/moved.hpp"
#include "surface/repair/point_order.hpp"
#include "surface/repair/weld_groups.hpp"
#include "surface/topology/disjoint_sets.hpp"
#include "surface/topology/mesh_corner.hpp"

namespace plumb {
namespace surface {
namespace {

/// The points that differ, ascending: so numbers compare as points do.
struct Places {
  std::vector<std::uint32_t> vertex;  // the first of each
  std::vector<Point3> points;
};

Places places_of(std::span<const Point3> points, std::span<const std::uint32_t> first,
                 std::span<const std::uint8_t> among) {
  Places places;
  for (std::uint32_t v = 0; v < points.size(); ++v)
    if (first[v] == v && (among.empty() || among[v] != 0)) places.vertex.push_back(v);
  std::ranges::sort(places.vertex,
                    [&](std::uint32_t l, std::uint32_t r) { return comes_before(points[l], points[r]); });
  places.points.reserve(places.vertex.size());
  for (const std::uint32_t v : places.vertex) places.points.push_back(points[v]);
  return places;
}

/// Of each place the least place of its group.
std::vector<std::uint32_t> chain_groups(const Places& places, const KdTree3& tree, const WeldOptions& options) {
  DisjointSets sets(places.points.size());
  std::vector<std::uint32_t> near;
  for (std::uint32_t i = 0; i < places.points.size(); ++i) {
    near = within(tree, places.points[i], options.tolerance, std::move(near));
    for (const std::uint32_t k : near) sets.unite(i, k);
  }
  std::vector<std::uint32_t> least(places.points.size());
  for (std::uint32_t i = 0; i < least.size(); ++i) least[i] = sets.find(i);
  return least;
}

std::vector<std::uint32_t> cluster_groups(const Places& places, const KdTree3& tree, const WeldOptions& options) {
  const auto& at = places.points;
  constexpr std::uint32_t free = no_group;
  std::vector<std::uint32_t> least(at.size(), free), near, group;
  for (std::uint32_t i = 0; i < at.size(); ++i) {
    if (least[i] != free) continue;
    least[i] = i;
    near = within(tree, at[i], options.tolerance, std::move(near));
    std::erase_if(near, [&](std::uint32_t k) { return least[k] != free; });
    std::ranges::sort(near, [&](std::uint32_t l, std::uint32_t r) {
      const Sign nearer = compare_distance(at[i], at[l], at[r]);
      return nearer != Sign::zero ? nearer == Sign::negative : l < r;
    });
    group.assign(1, i);
    for (const std::uint32_t k : near) {
      const auto reaches = [&](std::uint32_t other) {
        return compare_distance(at[k], at[other], options.tolerance) != Sign::positive;
      };
      if (!std::all_of(group.begin() + 1, group.end(), reaches)) continue;
      least[k] = i;
      group.push_back(k);
    }
  }
  return least;
}

}  // namespace

std::vector<std::uint32_t> weld_groups(std::span<const Point3> points, std::span<const std::uint32_t> first,
                                       std::span<const std::uint8_t> among, const WeldOptions& options) {
  std::vector<std::uint32_t> into(first.begin(), first.end());
  if (options.tolerance == 0) return into;
  const Places places = places_of(points, first, among);
  if (places.points.size() < 2) return into;
  const KdTree3 tree = build_kd_tree(places.points, {.execution = options.execution});
  const std::vector<std::uint32_t> least =
      options.rule == WeldRule::chains ? chain_groups(places, tree, options) : cluster_groups(places, tree, options);
  for (std::size_t i = 0; i < least.size(); ++i) into[places.vertex[i]] = places.vertex[least[i]];
  for (std::size_t v = 0; v < into.size(); ++v)
    if (first[v] != v) into[v] = into[first[v]];
  return into;
}

Weld weld_into(const TriangleMesh& mesh, std::span<const std::uint32_t> first, std::vector<std::uint32_t> into,
               TurnedOver turned_over) {
  Weld weld;
  weld.into = std::move(into);
  const auto at = [&](std::uint32_t v) -> const Point3& { return mesh.vertices[v]; };
  const auto moved = [&](const TriangleMesh::Triangle& t) {
    return TriangleMesh::Triangle{weld.into[t[0]], weld.into[t[1]], weld.into[t[2]]};
  };
  const auto is_turned = [&](const TriangleMesh::Triangle& t) {
    if (weld.into[t[0]] == first[t[0]] && weld.into[t[1]] == first[t[1]] && weld.into[t[2]] == first[t[2]])
      return false;
    const TriangleMesh::Triangle m = moved(t);
    return !names_a_vertex_twice(m) &&
           keeps_facing({at(t[0]), at(t[1]), at(t[2])}, {at(m[0]), at(m[1]), at(m[2])}) == Sign::negative;
  };
  for (bool changed = true; changed && turned_over == TurnedOver::refused;) {
    std::vector<std::uint32_t> apart;
    for (const auto& t : mesh.triangles) {
      if (!is_turned(t)) continue;
      for (const std::uint32_t v : t)
        if (weld.into[v] != first[v]) apart.push_back(weld.into[v]);
    }
    changed = !apart.empty();
    std::ranges::sort(apart);
    apart.erase(std::unique(apart.begin(), apart.end()), apart.end());
    weld.refused.insert(weld.refused.end(), apart.begin(), apart.end());
    for (std::size_t v = 0; v < weld.into.size() && changed; ++v)
      if (std::ranges::binary_search(apart, weld.into[v])) weld.into[v] = first[v];
  }
  std::ranges::sort(weld.refused);
  for (std::uint32_t v = 0; v < weld.into.size(); ++v)
    if (weld.into[v] != v) weld.merged.push_back({v, weld.into[v], how_far(at(v), at(weld.into[v]))});
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const TriangleMesh::Triangle& before = mesh.triangles[t];
    if (names_a_vertex_twice(moved(before))) {
      if (!names_a_vertex_twice(before)) weld.collapsed.push_back(t);
    } else if (turned_over == TurnedOver::kept && is_turned(before)) {
      weld.turned.push_back(t);
    }
  }
  return weld;
}

void require_tolerance(std::string_view function, double tolerance) {
  if (!(tolerance - tolerance == 0))
    throw NonFinite(std::string(function) + ": the tolerance is not a real number; give a finite one");
  if (tolerance < 0) throw InvalidShape(std::string(function) + ": the tolerance is negative; give one of at least 0");
}

}  // namespace surface

Weld find_weld(const TriangleMesh& mesh, const WeldOptions& options) {
  surface::require_tolerance("find_weld", options.tolerance);
  require_mesh("find_weld", mesh);
  const std::vector<std::uint32_t> first = first_equal(mesh.vertices);
  return surface::weld_into(mesh, first, surface::weld_groups(mesh.vertices, first, {}, options), options.turned_over);
}

TriangleMesh welded(const TriangleMesh& mesh, const Weld& weld) {
  TriangleMesh out{mesh.vertices, {}};
  out.triangles.reserve(mesh.triangles.size());
  auto collapsed = weld.collapsed.begin();
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (collapsed != weld.collapsed.end() && *collapsed == t) {
      ++collapsed;
      continue;
    }
    const auto& [a, b, c] = mesh.triangles[t];
    out.triangles.push_back({weld.into[a], weld.into[b], weld.into[c]});
  }
  return out;
}

}  // namespace plumb
