#include "query/polytope_hierarchy/nearest.hpp"

#include "arith/exact_number.hpp"
#include "figure/basic/finite_parts.hpp"
#include "plumb/figure/basic/polyhedron.hpp"
#include "query/polytope_hierarchy/nearest_way.hpp"
#include "query/separation/convex_body.hpp"
#include "query/separation/corner_numbers.hpp"
#include "query/separation/proved_corners.hpp"

namespace plumb {
namespace query::hierarchy {

CoreCorners corners_of(std::span<const Point3> points) { return *CoreCorners::of(BodyView{.vertices = points}); }

Candidates candidates_about(const PolytopeHierarchy& h, std::size_t level, std::uint32_t removed) {
  Candidates c;
  c.rank[c.size++] = removed;
  for (const std::uint32_t v : h.levels[level].neighbors_of_removed(removed - h.levels[level + 1].size))
    c.rank[c.size++] = v;
  for (std::size_t k = 0; k < c.size; ++k) c.points[k] = h.points[c.rank[k]];
  return c;
}

std::uint32_t fewest_removed(const HierarchyLevel& finer, std::span<const std::uint32_t> ranks) {
  return *std::ranges::min_element(ranks, {}, [&](std::uint32_t v) { return finer.removed_at(v).size(); });
}

std::optional<NearestOfHierarchy> nearest(const PolytopeHierarchy& h, const CoreCorners& body, std::size_t finest) {
  const CoreCorners polytope = corners_of(h.points);
  const auto coarsest = proved_nearest(body, corners_of(std::span(h.points).first(h.levels.back().size)));
  if (!coarsest) return {};
  NearestOfHierarchy found{coarsest->corners, coarsest->meets, h.levels.size() - 1, {}};
  for (std::size_t i = h.levels.size() - 1; i-- > finest && !found.meets;) {
    const HierarchyLevel& finer = h.levels[i];
    const std::uint32_t at = fewest_removed(finer, named(found.corners, 1).all());
    const auto beyond = beyond_plane(h, finer, at, NearestWay(body, polytope, found.corners));
    if (!beyond) continue;
    const Candidates candidates = candidates_about(h, i, *beyond);
    const auto proved = proved_nearest(body, corners_of(candidates.all()));
    if (!proved) return {};
    found = {proved->corners, proved->meets, i, *beyond};
    for (std::size_t k = 0; k < found.corners.size; ++k)
      found.corners.ends[k][1] = candidates.rank[found.corners.ends[k][1]];
  }
  return found;
}

namespace {

std::optional<NearestOfHierarchy> nearest_to(const PolytopeHierarchy& h, const Point3& p) {
  return nearest(h, corners_of({&p, 1}));
}

void require_point(std::string_view function, const Point3& p) { require_finite_parts(function, {"p"}, p); }

}  // namespace
}  // namespace query::hierarchy

Closest closest_points(const Point3& p, const PolytopeHierarchy& h) {
  using namespace query::hierarchy;
  require_point("closest_points", p);
  const auto found = nearest_to(h, p);
  if (!found || found->meets) return closest_points(p, h.polyhedron);
  const auto numbers = query::numbers_of(corners_of({&p, 1}), corners_of(h.points), found->corners);
  const Feature start{FeatureKind::edge, h.corners[found->corners.ends[0][1]]};
  return {numbers.on_a, numbers.on_b, numbers.distance, Feature{FeatureKind::vertex, 0},
          voronoi_region(h.polyhedron, p, start)};
}

double distance(const Point3& p, const PolytopeHierarchy& h) {
  using namespace query::hierarchy;
  require_point("distance", p);
  const auto found = nearest_to(h, p);
  if (!found) return distance(p, h.polyhedron);
  return found->meets ? 0 : query::distance_of(corners_of({&p, 1}), corners_of(h.points), found->corners);
}

Rational squared_distance_exact(const Point3& p, const PolytopeHierarchy& h) {
  using namespace query::hierarchy;
  require_point("squared_distance_exact", p);
  const auto found = nearest_to(h, p);
  if (!found) return squared_distance_exact(p, h.polyhedron);
  if (found->meets) return 0;
  return exact_number(query::square_of(corners_of({&p, 1}), corners_of(h.points), found->corners));
}

bool contains(const PolytopeHierarchy& h, const Point3& p) {
  using namespace query::hierarchy;
  require_point("contains", p);
  const auto found = nearest_to(h, p);
  return found ? found->meets : contains(h.polyhedron, p);
}

}  // namespace plumb
