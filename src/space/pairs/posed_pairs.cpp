// Under one regular pose the question without it; else a search of posed boxes.
#include "plumb/space/pairs/posed_pairs.hpp"

#include <algorithm>

#include "query/section/posed_triangles.hpp"
#include "space/pairs/pair_answers.hpp"
#include "space/pairs/pair_slots.hpp"
#include "space/pairs/posed_pair_search.hpp"

namespace plumb {
std::vector<TrianglePair> intersecting_pairs(const PosedMesh& a, const PosedMesh& b, const PairOptions& options) {
  constexpr const char* function = "intersecting_pairs";
  return space::are_moved_alike(function, a, b)
             ? intersecting_pairs(a.bvh, b.bvh, options)
             : space::all_pairs(space::PosedPairSearch(function, a, b, false, options), a.bvh.triangles.size(),
                                options.execution);
}
std::vector<TrianglePair> self_intersecting_pairs(const PosedMesh& mesh, const PairOptions& options) {
  constexpr const char* function = "self_intersecting_pairs";
  return space::is_moved_regularly(function, mesh)
             ? self_intersecting_pairs(mesh.bvh, options)
             : space::all_pairs(space::PosedPairSearch(function, mesh, mesh, true, options), mesh.bvh.triangles.size(),
                                options.execution);
}

PairCount count_intersecting_pairs(const PosedMesh& a, const PosedMesh& b, const PairOptions& options) {
  constexpr const char* function = "count_intersecting_pairs";
  return space::are_moved_alike(function, a, b)
             ? count_intersecting_pairs(a.bvh, b.bvh, options)
             : space::counted_pairs(space::PosedPairSearch(function, a, b, false, options),
                                    space::is_split(a.bvh) || space::is_split(b.bvh), options.execution);
}
PairCount count_self_intersecting_pairs(const PosedMesh& mesh, const PairOptions& options) {
  constexpr const char* function = "count_self_intersecting_pairs";
  return space::is_moved_regularly(function, mesh)
             ? count_self_intersecting_pairs(mesh.bvh, options)
             : space::counted_pairs(space::PosedPairSearch(function, mesh, mesh, true, options),
                                    space::is_split(mesh.bvh), options.execution);
}

std::optional<TrianglePair> any_intersecting_pair(const PosedMesh& a, const PosedMesh& b, const PairOptions& options) {
  constexpr const char* function = "any_intersecting_pair";
  return space::are_moved_alike(function, a, b)
             ? any_intersecting_pair(a.bvh, b.bvh, options)
             : space::any_pair(space::PosedPairSearch(function, a, b, false, options));
}
std::optional<TrianglePair> any_self_intersecting_pair(const PosedMesh& mesh, const PairOptions& options) {
  constexpr const char* function = "any_self_intersecting_pair";
  return space::is_moved_regularly(function, mesh)
             ? any_self_intersecting_pair(mesh.bvh, options)
             : space::any_pair(space::PosedPairSearch(function, mesh, mesh, true, options));
}

std::vector<Intersection3> intersections(const PosedMesh& a, const PosedMesh& b, std::span<const TrianglePair> pairs,
                                         const PairOptions& options) {
  space::require_pose("intersections", "a", a.pose);
  space::require_pose("intersections", "b", b.pose);
  const std::vector<std::uint32_t> slots_a = space::slots_of(a.bvh), slots_b = space::slots_of(b.bvh);
  space::require_pairs(pairs, slots_a.size(), slots_b.size());
  std::vector<Intersection3> common(pairs.size());
  constexpr std::size_t part_size = 16;
  const std::size_t parts = space::blocks_of(pairs.size(), part_size);
  space::for_parts("intersections", options.execution, options.progress, parts, [&](std::size_t part) {
    const std::size_t to = std::min(pairs.size(), (part + 1) * part_size);
    for (std::size_t i = part * part_size; i < to; ++i)
      common[i] = query::intersection(a.triangle(slots_a[pairs[i].a]), b.triangle(slots_b[pairs[i].b]));
  });
  return common;
}

}  // namespace plumb
