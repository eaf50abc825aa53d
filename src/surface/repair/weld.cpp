#include "plumb/surface/repair/weld.hpp"

#include <algorithm>
#include <optional>

#include "figure/basic/mesh_input.hpp"
#include "plumb/certify/compare_distance.hpp"
#include "plumb/figure/basic/equal_points.hpp"
#include "plumb/surface/topology/topology.hpp"
#include "surface/repair/marked_points.hpp"
#include "surface/repair/moved.hpp"
#include "surface/repair/point_order.hpp"
#include "surface/repair/weld_groups.hpp"
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

/// The points of one cluster, so far.
class Cluster {
 public:
  /// Those that may join.
  Cluster(std::span<const Point3> near, double tolerance) : near_(near), tolerance_(tolerance) {
    if (near.size() > few) joined_.emplace(near, Execution::serial);
  }
  /// Does the point join, which is within the tolerance of all that have?
  bool joins(std::uint32_t k) {
    if (joined_) {
      if (joined_->any_beyond(near_[k], tolerance_)) return false;
      joined_->mark(k);
      return true;
    }
    for (const std::uint32_t other : members_)
      if (compare_distance(near_[k], near_[other], tolerance_) == Sign::positive) return false;
    members_.push_back(k);
    return true;
  }

 private:
  static constexpr std::size_t few = 32;  // all pairs are quicker than a tree
  std::span<const Point3> near_;
  double tolerance_;
  std::vector<std::uint32_t> members_;
  std::optional<MarkedPoints> joined_;
};

/// Those that are free and within the tolerance of the place, which itself is not.
void find_free(const Places& places, const MarkedPoints& free, std::uint32_t place, double tolerance,
               std::vector<std::uint32_t>& near) {
  near.clear();
  free.add_within(places.points[place], tolerance, near);
}

/// Tells of each place the least place of its group: what is reached from it, step by step.
std::vector<std::uint32_t> chain_groups(const Places& places, MarkedPoints& free, const WeldOptions& options) {
  std::vector<std::uint32_t> least(places.points.size(), no_group), near, reached;
  for (std::uint32_t i = 0; i < least.size(); ++i) {
    if (least[i] != no_group) continue;
    const auto reach = [&](std::uint32_t k) {
      free.unmark(k);
      least[k] = i;
      reached.push_back(k);
    };
    reach(i);
    while (!reached.empty()) {
      const std::uint32_t from = reached.back();
      reached.pop_back();
      find_free(places, free, from, options.tolerance, near);
      for (const std::uint32_t k : near) reach(k);
    }
  }
  return least;
}

std::vector<std::uint32_t> cluster_groups(const Places& places, MarkedPoints& free, const WeldOptions& options) {
  const auto& at = places.points;
  std::vector<std::uint32_t> least(at.size(), no_group), near;
  std::vector<Point3> points;
  for (std::uint32_t i = 0; i < at.size(); ++i) {
    if (least[i] != no_group) continue;
    least[i] = i;
    free.unmark(i);
    find_free(places, free, i, options.tolerance, near);
    std::ranges::sort(near, [&](std::uint32_t l, std::uint32_t r) {
      const Sign nearer = compare_distance(at[i], at[l], at[r]);
      return nearer != Sign::zero ? nearer == Sign::negative : l < r;
    });
    points.clear();
    for (const std::uint32_t k : near) points.push_back(at[k]);
    Cluster cluster(points, options.tolerance);
    for (std::uint32_t k = 0; k < near.size(); ++k) {
      if (!cluster.joins(k)) continue;
      least[near[k]] = i;
      free.unmark(near[k]);
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
  MarkedPoints free(places.points, options.execution);
  for (std::uint32_t i = 0; i < places.points.size(); ++i) free.mark(i);
  const std::vector<std::uint32_t> least =
      options.rule == WeldRule::chains ? chain_groups(places, free, options) : cluster_groups(places, free, options);
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
