#include <algorithm>
#include <numeric>

#include "plumb/arith/error.hpp"
#include "plumb/certify/direction.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "query/polytope_hierarchy/fan.hpp"

namespace plumb {
namespace query::hierarchy {
namespace {

/// The edges of a hull: neighbors of each of its vertices, by their places in hull.vertices, in the order in which they
/// stand around it.
struct Skeleton {
  std::vector<std::uint32_t> first, ring;
  [[nodiscard]] std::span<const std::uint32_t> of(std::size_t v) const {
    return std::span(ring).subspan(first[v], first[v + 1] - first[v]);
  }
};

struct Turn {
  std::uint32_t from, to;  // two neighbors, with a face between them
};

/// Each turn after that which ends where it begins.
void chain(std::span<Turn> turns) {
  std::ranges::sort(turns, {}, &Turn::from);
  std::vector<Turn> in_order;
  in_order.reserve(turns.size());
  for (std::uint32_t at = turns[0].from; in_order.size() < turns.size();) {
    in_order.push_back(*std::ranges::lower_bound(turns, at, {}, &Turn::from));
    at = in_order.back().to;
  }
  std::ranges::copy(in_order, turns.begin());
}

Skeleton skeleton_of(const Hull3& hull) {
  const std::size_t n = hull.vertices.size();
  Skeleton s{std::vector<std::uint32_t>(n + 1, 0), {}};
  const auto place = [&](std::uint32_t v) {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(hull.vertices, v) - hull.vertices.begin());
  };
  std::vector<std::uint32_t> corners(hull.corners.size());
  std::ranges::transform(hull.corners, corners.begin(), place);
  for (const std::uint32_t v : corners) ++s.first[v + 1];
  for (std::size_t v = 0; v < n; ++v) s.first[v + 1] += s.first[v];
  std::vector<std::uint32_t> end(s.first.begin(), s.first.end() - 1);
  std::vector<Turn> turns(corners.size());
  for (std::size_t f = 0; f < hull.face_count(); ++f) {
    const auto face = std::span(corners).subspan(hull.first[f], hull.first[f + 1] - hull.first[f]);
    for (std::size_t k = 0; k < face.size(); ++k)
      turns[end[face[k]]++] = {face[k + 1 < face.size() ? k + 1 : 0], face[k > 0 ? k - 1 : face.size() - 1]};
  }
  for (std::size_t v = 0; v < n; ++v) chain(std::span(turns).subspan(s.first[v], s.first[v + 1] - s.first[v]));
  s.ring.resize(turns.size());
  std::ranges::transform(turns, s.ring.begin(), &Turn::from);
  return s;
}

/// Of few neighbors first, and none beside one that was taken.
std::vector<bool> independent_set(const Skeleton& s) {
  const std::size_t n = s.first.size() - 1;
  std::vector<bool> taken(n, false), beside(n, false);
  for (std::size_t degree = 0; degree <= PolytopeHierarchy::most_neighbors; ++degree) {
    for (std::size_t v = 0; v < n; ++v) {
      if (s.of(v).size() != degree || beside[v]) continue;
      taken[v] = true;
      for (const std::uint32_t w : s.of(v)) beside[w] = true;
    }
  }
  return taken;
}

/// A polytope while it is built; its vertices are numbers of the finest one's.
struct Draft {
  std::vector<std::uint32_t> vertices;
  Skeleton edges;
  std::vector<bool> removed;
};

std::vector<Point3> points_at(const std::vector<Point3>& all, const std::vector<std::uint32_t>& which) {
  std::vector<Point3> points(which.size());
  std::ranges::transform(which, points.begin(), [&](std::uint32_t v) { return all[v]; });
  return points;
}

std::vector<Draft> drafts_of(const std::vector<Point3>& extreme, Hull3 hull) {
  std::vector<std::uint32_t> all(extreme.size());
  std::iota(all.begin(), all.end(), 0U);
  std::vector<Draft> drafts{{std::move(all), skeleton_of(hull), {}}};
  while (drafts.back().vertices.size() > PolytopeHierarchy::fewest_vertices) {
    Draft& last = drafts.back();
    std::vector<bool> removed = independent_set(last.edges);
    std::vector<std::uint32_t> left;
    for (std::size_t v = 0; v < removed.size(); ++v) {
      if (!removed[v]) left.push_back(last.vertices[v]);
    }
    hull = convex_hull(points_at(extreme, left));
    if (hull.dimension < 3) break;
    last.removed = std::move(removed);
    drafts.push_back({std::move(left), skeleton_of(hull), {}});
  }
  return drafts;
}

/// Numbers of the finest polytope's vertices such that every polytope has the first ones.
std::vector<std::uint32_t> ranks_of(const std::vector<Draft>& drafts) {
  std::vector<std::uint32_t> rank(drafts.front().vertices.size());
  std::uint32_t next = 0;
  for (const std::uint32_t v : drafts.back().vertices) rank[v] = next++;
  for (std::size_t i = drafts.size() - 1; i-- > 0;) {
    for (std::size_t v = 0; v < drafts[i].vertices.size(); ++v) {
      if (drafts[i].removed[v]) rank[drafts[i].vertices[v]] = next++;
    }
  }
  return rank;
}

/// `wanted`: which neighbors are listed, of the vertices from rank `from` up to `to`.
template <class Wanted>
void list(const Draft& d, const std::vector<std::uint32_t>& rank, std::uint32_t from, std::uint32_t to, Wanted wanted,
          std::vector<std::uint32_t>& first, std::vector<std::uint32_t>& listed) {
  std::vector<std::uint32_t> at(to - from);
  for (std::uint32_t v = 0; v < d.vertices.size(); ++v) {
    const std::uint32_t r = rank[d.vertices[v]];
    if (r >= from && r < to) at[r - from] = v;
  }
  for (const std::uint32_t v : at) {
    for (const std::uint32_t w : d.edges.of(v)) {
      const std::uint32_t r = rank[d.vertices[w]];
      if (wanted(r)) listed.push_back(r);
    }
    first.push_back(static_cast<std::uint32_t>(listed.size()));
  }
}

}  // namespace
}  // namespace query::hierarchy

PolytopeHierarchy build_polytope_hierarchy(ConvexPolyhedron3 polyhedron) {
  using namespace query::hierarchy;
  const Hull3 hull = convex_hull(polyhedron.mesh.vertices);
  if (polyhedron.mesh.corners.empty() || hull.dimension < 3) {
    throw InvalidShape(
        "build_polytope_hierarchy: the polyhedron has no faces around a solid; make it by convex_polyhedron");
  }
  const std::vector<Point3> extreme = points_at(polyhedron.mesh.vertices, hull.vertices);
  const std::vector<Draft> drafts = drafts_of(extreme, hull);
  const std::vector<std::uint32_t> rank = ranks_of(drafts);

  PolytopeHierarchy h;
  const std::size_t n = extreme.size();
  h.vertices.resize(n), h.points.resize(n), h.corners.resize(n);
  for (std::size_t v = 0; v < n; ++v) h.vertices[rank[v]] = hull.vertices[v], h.points[rank[v]] = extreme[v];
  std::vector<std::uint32_t> corner_at(polyhedron.mesh.vertices.size());
  for (std::uint32_t c = 0; c < polyhedron.mesh.corners.size(); ++c) corner_at[polyhedron.mesh.corners[c]] = c;
  for (std::size_t r = 0; r < n; ++r) h.corners[r] = corner_at[h.vertices[r]];
  h.polyhedron = std::move(polyhedron);
  list(
      drafts[0], rank, 0, static_cast<std::uint32_t>(n), [](std::uint32_t) { return true; }, h.first_neighbor,
      h.neighbors);
  for (std::uint32_t r = 0; r < n; ++r) {
    const auto neighbors = h.neighbors_of(r);
    if (const auto normal = fan_normal(h.points, r, neighbors))
      h.rims.push_back({{r, *normal}, {neighbors.begin(), neighbors.end()}});
  }
  h.levels.assign(drafts.size(), {});
  const auto coarsest = std::span(h.points).first(drafts.back().vertices.size());
  const Hull3 triangles = convex_hull(coarsest, {.triangulate = true});
  for (std::size_t f = 0; f < triangles.face_count(); ++f) {
    const auto t = triangles.face(f);
    h.coarsest_faces.push_back({t[0], t[1], t[2]});
  }
  for (std::size_t i = 0; i < drafts.size(); ++i) {
    HierarchyLevel& level = h.levels[i];
    level.size = static_cast<std::uint32_t>(drafts[i].vertices.size());
    if (i + 1 == drafts.size()) break;
    const auto coarser = static_cast<std::uint32_t>(drafts[i + 1].vertices.size());
    const auto is_removed = [coarser](std::uint32_t r) { return r >= coarser; };
    list(drafts[i], rank, 0, coarser, is_removed, level.first_removed, level.removed);
    list(
        drafts[i], rank, coarser, level.size, [](std::uint32_t) { return true; }, level.first_around, level.around);
    for (std::uint32_t r = 0; r < coarser; ++r) {
      if (const auto normal = fan_normal(h.points, r, level.removed_at(r))) level.fans.push_back({r, *normal});
    }
  }
  return h;
}

std::size_t bytes(const PolytopeHierarchy& h) {
  const auto of = []<class T>(const std::vector<T>& v) { return v.size() * sizeof(T); };
  const ConvexPolyhedron3& p = h.polyhedron;
  std::size_t sum = sizeof h + of(p.mesh.vertices) + of(p.mesh.corners) + of(p.mesh.first) + of(p.across) +
                    of(p.neighbors) + of(p.first_neighbor) + of(h.vertices) + of(h.points) + of(h.corners) +
                    of(h.levels) + of(h.first_neighbor) + of(h.neighbors) + of(h.rims) + of(h.coarsest_faces);
  for (const PolytopeHierarchy::Rim& r : h.rims) sum += of(r.neighbors);
  for (const HierarchyLevel& l : h.levels)
    sum += of(l.first_removed) + of(l.removed) + of(l.first_around) + of(l.around) + of(l.fans);
  return sum;
}

}  // namespace plumb
