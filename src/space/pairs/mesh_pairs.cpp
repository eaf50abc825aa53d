#include "plumb/space/pairs/mesh_pairs.hpp"

#include <algorithm>

#include "plumb/query/section/intersection.hpp"
#include "space/pairs/pair_answers.hpp"
#include "space/pairs/pair_search.hpp"
#include "space/pairs/pair_slots.hpp"

namespace plumb {

std::vector<TrianglePair> intersecting_pairs(const Bvh& a, const Bvh& b, const PairOptions& options) {
  return space::all_pairs(space::PairSearch("intersecting_pairs", a, b, false, options), a.triangles.size(),
                          options.execution);
}
std::vector<TrianglePair> self_intersecting_pairs(const Bvh& mesh, const PairOptions& options) {
  return space::all_pairs(space::PairSearch("self_intersecting_pairs", mesh, mesh, true, options),
                          mesh.triangles.size(), options.execution);
}

PairCount count_intersecting_pairs(const Bvh& a, const Bvh& b, const PairOptions& options) {
  return space::counted_pairs(space::PairSearch("count_intersecting_pairs", a, b, false, options),
                              space::is_split(a) || space::is_split(b), options.execution);
}
PairCount count_self_intersecting_pairs(const Bvh& mesh, const PairOptions& options) {
  return space::counted_pairs(space::PairSearch("count_self_intersecting_pairs", mesh, mesh, true, options),
                              space::is_split(mesh), options.execution);
}

std::optional<TrianglePair> any_intersecting_pair(const Bvh& a, const Bvh& b, const PairOptions& options) {
  return space::any_pair(space::PairSearch("any_intersecting_pair", a, b, false, options));
}
std::optional<TrianglePair> any_self_intersecting_pair(const Bvh& mesh, const PairOptions& options) {
  return space::any_pair(space::PairSearch("any_self_intersecting_pair", mesh, mesh, true, options));
}

std::vector<Intersection3> intersections(const Bvh& a, const Bvh& b, std::span<const TrianglePair> pairs,
                                         const PairOptions& options) {
  const std::vector<std::uint32_t> slots_a = space::slots_of(a), slots_b = space::slots_of(b);
  space::require_pairs(pairs, slots_a.size(), slots_b.size());
  std::vector<Intersection3> common(pairs.size());
  constexpr std::size_t part_size = 256;
  const std::size_t parts = space::blocks_of(pairs.size(), part_size);
  space::for_parts("intersections", options.execution, options.progress, parts, [&](std::size_t part) {
    const std::size_t to = std::min(pairs.size(), (part + 1) * part_size);
    for (std::size_t i = part * part_size; i < to; ++i) {
      common[i] = intersection(a.triangle(slots_a[pairs[i].a]), b.triangle(slots_b[pairs[i].b]));
    }
  });
  return common;
}

}  // namespace plumb
