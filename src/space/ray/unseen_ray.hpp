// Which triangles of a posed mesh may a ray hit that the mesh does not see (seen_ray.hpp)?  By posed boxes, nearer ones
// first.
//
// Law: every triangle that the ray hits at a parameter of at most the limit that the search then has is visited.
// Source: RTCD 4.2.6, 6.3.2.
// Cost: some 100 ns for each node that is looked at, and what the search asks of each triangle of the leaves.
#pragma once

#include <algorithm>
#include <tuple>

#include "plumb/arith/interval.hpp"
#include "plumb/query/ray/hits.hpp"
#include "plumb/space/bvh/descend.hpp"
#include "plumb/space/bvh/descend_compact.hpp"
#include "space/bvh/posed_box.hpp"
#include "space/ray/hit_search.hpp"
#include "space/ray/nearest_hit.hpp"

namespace plumb::space {

/// At most the parameter at which the ray, which hits it, enters the box.
inline double entry_below(const AnyRay& ray, const Aabb3& box) {
  const auto on = [&](double origin, double along, double end, double low, double high) {
    const Interval from(origin);
    const Interval way = ray.kind == AnyRay::Kind::segment ? Interval(end) - from : Interval(along);
    return quotient(Interval(low, high) - from, way).lower;
  };
  const auto& [o, d, e] = std::tie(ray.origin, ray.direction, ray.end);
  const double least = ray.kind == AnyRay::Kind::line ? -Interval::infinity : 0;
  return std::min(most_parameter,
                  std::max({least, on(o.x, d.x, e.x, box.min.x, box.max.x), on(o.y, d.y, e.y, box.min.y, box.max.y),
                            on(o.z, d.z, e.z, box.min.z, box.max.z)}));
}

template <class Mesh>
void visit_unseen(const PosedMeshOf<Mesh>& mesh, const AnyRay& ray, HitSearch& search) {
  const auto bound = [&](const BoxNode& node) {
    const Aabb3 box = around(mesh, node);
    if (!is_bounded(box)) return -Interval::infinity;
    return hits(ray, box) ? entry_below(ray, box) : Interval::infinity;
  };
  double limit = search.limit();
  descend_nearer_first(mesh.bvh.tree, limit, bound, [&](std::uint32_t first, std::uint32_t count, double& until) {
    for (std::uint32_t slot = first; slot < first + count; ++slot) {
      until = std::min(until, search.visit(slot, false, -Interval::infinity, Interval::infinity));
      if (until == -Interval::infinity) return Descent::stop;
    }
    return Descent::go_on;
  });
}

}  // namespace plumb::space
