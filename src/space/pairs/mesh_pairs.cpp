#include "plumb/space/pairs/mesh_pairs.hpp"

#include <algorithm>

#include "plumb/query/section/intersection.hpp"
#include "space/pairs/pair_answers.hpp"
#include "space/pairs/pair_search.hpp"
#include "space/pairs/pair_slots.hpp"

namespace plumb {
namespace space {
namespace {

template <class Mesh>
std::vector<Intersection3> intersections_of(const Mesh& a, const Mesh& b, std::span<const TrianglePair> pairs,
                                            const PairOptions& options, std::vector<Intersection3> common) {
  const std::vector<std::uint32_t> slots_a = slots_of(a), slots_b = slots_of(b);
  require_pairs(pairs, slots_a.size(), slots_b.size());
  common.clear(), common.resize(pairs.size());
  constexpr std::size_t part_size = 256;
  const std::size_t parts = blocks_of(pairs.size(), part_size);
  for_parts("intersections", options.execution, options.progress, parts, [&](std::size_t part) {
    const std::size_t to = std::min(pairs.size(), (part + 1) * part_size);
    for (std::size_t i = part * part_size; i < to; ++i) {
      common[i] = intersection(a.triangle(slots_a[pairs[i].a]), b.triangle(slots_b[pairs[i].b]));
    }
  });
  return common;
}

}  // namespace
}  // namespace space

// Each question of the mesh's tree in its usual and in its compact form.
#define PLUMB_MESH_PAIRS(Mesh)                                                                                     \
  std::vector<TrianglePair> intersecting_pairs(const Mesh& a, const Mesh& b, const PairOptions& options,           \
                                               std::vector<TrianglePair> rows) {                                   \
    return space::all_pairs(space::PairSearch("intersecting_pairs", a, b, false, options), a.slots(),              \
                            options.execution, std::move(rows));                                                   \
  }                                                                                                                \
  std::vector<TrianglePair> self_intersecting_pairs(const Mesh& mesh, const PairOptions& options,                  \
                                                    std::vector<TrianglePair> rows) {                              \
    return space::all_pairs(space::PairSearch("self_intersecting_pairs", mesh, mesh, true, options), mesh.slots(), \
                            options.execution, std::move(rows));                                                   \
  }                                                                                                                \
  PairCount count_intersecting_pairs(const Mesh& a, const Mesh& b, const PairOptions& options) {                   \
    return space::counted_pairs(space::PairSearch("count_intersecting_pairs", a, b, false, options),               \
                                space::is_split(a) || space::is_split(b), options.execution);                      \
  }                                                                                                                \
  PairCount count_self_intersecting_pairs(const Mesh& mesh, const PairOptions& options) {                          \
    return space::counted_pairs(space::PairSearch("count_self_intersecting_pairs", mesh, mesh, true, options),     \
                                space::is_split(mesh), options.execution);                                         \
  }                                                                                                                \
  std::optional<TrianglePair> any_intersecting_pair(const Mesh& a, const Mesh& b, const PairOptions& options) {    \
    return space::any_pair(space::PairSearch("any_intersecting_pair", a, b, false, options));                      \
  }                                                                                                                \
  std::optional<TrianglePair> any_self_intersecting_pair(const Mesh& mesh, const PairOptions& options) {           \
    return space::any_pair(space::PairSearch("any_self_intersecting_pair", mesh, mesh, true, options));            \
  }                                                                                                                \
  std::vector<Intersection3> intersections(const Mesh& a, const Mesh& b, std::span<const TrianglePair> pairs,      \
                                           const PairOptions& options, std::vector<Intersection3> rows) {          \
    return space::intersections_of(a, b, pairs, options, std::move(rows));                                         \
  }
PLUMB_MESH_PAIRS(Bvh)
PLUMB_MESH_PAIRS(CompactBvh)
#undef PLUMB_MESH_PAIRS

}  // namespace plumb
