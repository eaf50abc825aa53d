// Under one regular pose the question without it; else a search of posed boxes.
#include "plumb/space/pairs/posed_pairs.hpp"

#include <algorithm>

#include "query/section/posed_triangles.hpp"
#include "space/pairs/pair_answers.hpp"
#include "space/pairs/pair_slots.hpp"
#include "space/pairs/posed_pair_search.hpp"

namespace plumb {
namespace space {
namespace {

template <class Mesh>
std::vector<Intersection3> posed_intersections(const PosedMeshOf<Mesh>& a, const PosedMeshOf<Mesh>& b,
                                               std::span<const TrianglePair> pairs, const PairOptions& options,
                                               std::vector<Intersection3> common) {
  require_pose("intersections", "a", a.pose);
  require_pose("intersections", "b", b.pose);
  const std::vector<std::uint32_t> slots_a = slots_of(a.bvh), slots_b = slots_of(b.bvh);
  require_pairs(pairs, slots_a.size(), slots_b.size());
  common.clear(), common.resize(pairs.size());
  constexpr std::size_t part_size = 16;
  const std::size_t parts = blocks_of(pairs.size(), part_size);
  for_parts("intersections", options.execution, options.progress, parts, [&](std::size_t part) {
    const std::size_t to = std::min(pairs.size(), (part + 1) * part_size);
    for (std::size_t i = part * part_size; i < to; ++i)
      common[i] = query::intersection(a.triangle(slots_a[pairs[i].a]), b.triangle(slots_b[pairs[i].b]));
  });
  return common;
}

}  // namespace
}  // namespace space

// Each question of the mesh's tree in its usual and in its compact form.
#define PLUMB_POSED_PAIRS(Mesh)                                                                                  \
  std::vector<TrianglePair> intersecting_pairs(const Mesh& a, const Mesh& b, const PairOptions& options,         \
                                               std::vector<TrianglePair> rows) {                                 \
    constexpr const char* function = "intersecting_pairs";                                                       \
    return space::are_moved_alike(function, a, b)                                                                \
               ? intersecting_pairs(a.bvh, b.bvh, options, std::move(rows))                                      \
               : space::all_pairs(space::PosedPairSearch(function, a, b, false, options), a.bvh.slots(),         \
                                  options.execution, std::move(rows));                                           \
  }                                                                                                              \
  std::vector<TrianglePair> self_intersecting_pairs(const Mesh& mesh, const PairOptions& options,                \
                                                    std::vector<TrianglePair> rows) {                            \
    constexpr const char* function = "self_intersecting_pairs";                                                  \
    return space::is_moved_regularly(function, mesh)                                                             \
               ? self_intersecting_pairs(mesh.bvh, options, std::move(rows))                                     \
               : space::all_pairs(space::PosedPairSearch(function, mesh, mesh, true, options), mesh.bvh.slots(), \
                                  options.execution, std::move(rows));                                           \
  }                                                                                                              \
  PairCount count_intersecting_pairs(const Mesh& a, const Mesh& b, const PairOptions& options) {                 \
    constexpr const char* function = "count_intersecting_pairs";                                                 \
    return space::are_moved_alike(function, a, b)                                                                \
               ? count_intersecting_pairs(a.bvh, b.bvh, options)                                                 \
               : space::counted_pairs(space::PosedPairSearch(function, a, b, false, options),                    \
                                      space::is_split(a.bvh) || space::is_split(b.bvh), options.execution);      \
  }                                                                                                              \
  PairCount count_self_intersecting_pairs(const Mesh& mesh, const PairOptions& options) {                        \
    constexpr const char* function = "count_self_intersecting_pairs";                                            \
    return space::is_moved_regularly(function, mesh)                                                             \
               ? count_self_intersecting_pairs(mesh.bvh, options)                                                \
               : space::counted_pairs(space::PosedPairSearch(function, mesh, mesh, true, options),               \
                                      space::is_split(mesh.bvh), options.execution);                             \
  }                                                                                                              \
  std::optional<TrianglePair> any_intersecting_pair(const Mesh& a, const Mesh& b, const PairOptions& options) {  \
    constexpr const char* function = "any_intersecting_pair";                                                    \
    return space::are_moved_alike(function, a, b)                                                                \
               ? any_intersecting_pair(a.bvh, b.bvh, options)                                                    \
               : space::any_pair(space::PosedPairSearch(function, a, b, false, options));                        \
  }                                                                                                              \
  std::optional<TrianglePair> any_self_intersecting_pair(const Mesh& mesh, const PairOptions& options) {         \
    constexpr const char* function = "any_self_intersecting_pair";                                               \
    return space::is_moved_regularly(function, mesh)                                                             \
               ? any_self_intersecting_pair(mesh.bvh, options)                                                   \
               : space::any_pair(space::PosedPairSearch(function, mesh, mesh, true, options));                   \
  }                                                                                                              \
  std::vector<Intersection3> intersections(const Mesh& a, const Mesh& b, std::span<const TrianglePair> pairs,    \
                                           const PairOptions& options, std::vector<Intersection3> rows) {        \
    return space::posed_intersections(a, b, pairs, options, std::move(rows));                                    \
  }
PLUMB_POSED_PAIRS(PosedMesh)
PLUMB_POSED_PAIRS(PosedCompactMesh)
#undef PLUMB_POSED_PAIRS

}  // namespace plumb
