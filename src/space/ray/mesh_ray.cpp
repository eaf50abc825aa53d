#include "plumb/space/ray/mesh_ray.hpp"

#include <algorithm>

#include "query/ray/numbers.hpp"
#include "space/bvh/blocks.hpp"
#include "space/bvh/equal_lengths.hpp"
#include "space/bvh/parts.hpp"
#include "space/ray/hit_search.hpp"

namespace plumb {
namespace {

constexpr std::size_t rays_of_block = 256;

/// answer(the search along the ray).
template <class Search, class Mesh, class Answer>
auto searched(const char* function, const AnyRay& ray, const Mesh& mesh, HitRule rule, const Answer& answer) {
  if (!query::is_sound(ray)) [[unlikely]]
    query::require_ray(function, ray);
  Search search(ray, mesh, rule);
  const space::RayTask task = search.task();
  space::visit_triangles(mesh, {&task, 1});
  return answer(search);
}

/// out[i] = answer(the search along rays[i]); a block's rays descend together.
template <class Search, class Mesh, class Out, class Answer>
void search_all(const char* function, std::span<const AnyRay> rays, const Mesh& mesh, std::span<Out> out,
                const ManyRays& options, const Answer& answer) {
  space::require_equal_lengths(function, "out", out.size(), "rays", rays.size());
  const std::size_t parts = space::blocks_of(rays.size(), rays_of_block);
  space::for_parts(function, options.execution, options.progress, parts, [&](std::size_t part) {
    const std::size_t from = part * rays_of_block, to = std::min(rays.size(), from + rays_of_block);
    std::vector<Search> searches;
    std::vector<space::RayTask> tasks;
    searches.reserve(to - from);
    tasks.reserve(to - from);
    for (std::size_t i = from; i < to; ++i) {
      if (!query::is_sound(rays[i])) query::require_ray(function, rays[i]);
      tasks.push_back(searches.emplace_back(rays[i], mesh, options.rule).task());
    }
    space::visit_triangles(mesh, tasks);
    for (std::size_t i = from; i < to; ++i) out[i] = answer(searches[i - from]);
  });
}

using space::FirstHit, space::AnyHit, space::CountedHits, space::OrderedHits;

constexpr auto first_of = [](const FirstHit& s) { return s.first(); };
constexpr auto first_number_of = [](const FirstHit& s) { return s.first_number(); };
constexpr auto first_number_or_none = [](const FirstHit& s) { return s.first_number().value_or(no_triangle); };
constexpr auto is_found = [](const AnyHit& s) { return s.found(); };
constexpr auto is_found_byte = [](const AnyHit& s) { return static_cast<std::uint8_t>(s.found() ? 1 : 0); };
constexpr auto all_of = [](OrderedHits& s) { return s.in_order(); };
constexpr auto count_of = [](CountedHits& s) { return s.count(); };

}  // namespace

// Each question of the mesh's tree in its usual and in its compact form.
#define PLUMB_MESH_RAYS(Mesh)                                                                                       \
  std::optional<NumberedHit> first_hit(const AnyRay& ray, const Mesh& mesh, HitRule rule) {                         \
    return searched<FirstHit>("first_hit", ray, mesh, rule, first_of);                                              \
  }                                                                                                                 \
  std::optional<std::uint32_t> first_triangle(const AnyRay& ray, const Mesh& mesh, HitRule rule) {                  \
    return searched<FirstHit>("first_triangle", ray, mesh, rule, first_number_of);                                  \
  }                                                                                                                 \
  bool hits(const AnyRay& ray, const Mesh& mesh, HitRule rule) {                                                    \
    return searched<AnyHit>("hits", ray, mesh, rule, is_found);                                                     \
  }                                                                                                                 \
  std::vector<NumberedHit> ordered_hits(const AnyRay& ray, const Mesh& mesh, HitRule rule) {                        \
    return searched<OrderedHits>("ordered_hits", ray, mesh, rule, all_of);                                          \
  }                                                                                                                 \
  std::size_t count_hits(const AnyRay& ray, const Mesh& mesh, HitRule rule) {                                       \
    return searched<CountedHits>("count_hits", ray, mesh, rule, count_of);                                          \
  }                                                                                                                 \
  void first_hits(std::span<const AnyRay> rays, const Mesh& mesh, std::span<std::optional<NumberedHit>> out,        \
                  const ManyRays& options) {                                                                        \
    search_all<FirstHit>("first_hits", rays, mesh, out, options, first_of);                                         \
  }                                                                                                                 \
  void first_triangles(std::span<const AnyRay> rays, const Mesh& mesh, std::span<std::uint32_t> out,                \
                       const ManyRays& options) {                                                                   \
    search_all<FirstHit>("first_triangles", rays, mesh, out, options, first_number_or_none);                        \
  }                                                                                                                 \
  void hits(std::span<const AnyRay> rays, const Mesh& mesh, std::span<std::uint8_t> out, const ManyRays& options) { \
    search_all<AnyHit>("hits", rays, mesh, out, options, is_found_byte);                                            \
  }                                                                                                                 \
  void ordered_hits(std::span<const AnyRay> rays, const Mesh& mesh, std::span<std::vector<NumberedHit>> out,        \
                    const ManyRays& options) {                                                                      \
    search_all<OrderedHits>("ordered_hits", rays, mesh, out, options, all_of);                                      \
  }                                                                                                                 \
  void count_hits(std::span<const AnyRay> rays, const Mesh& mesh, std::span<std::size_t> out,                       \
                  const ManyRays& options) {                                                                        \
    search_all<CountedHits>("count_hits", rays, mesh, out, options, count_of);                                      \
  }
PLUMB_MESH_RAYS(Bvh)
PLUMB_MESH_RAYS(CompactBvh)
#undef PLUMB_MESH_RAYS

}  // namespace plumb
