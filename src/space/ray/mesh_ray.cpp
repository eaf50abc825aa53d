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

template <class Search>
Search searched(const char* function, const AnyRay& ray, const Bvh& bvh, HitRule rule) {
  if (!query::is_sound(ray)) [[unlikely]]
    query::require_ray(function, ray);
  Search search(ray, bvh, rule);
  const space::RayTask task = search.task();
  space::visit_triangles(bvh, {&task, 1});
  return search;
}

/// out[i] = answer(the search along rays[i]); a block's rays descend together.
template <class Search, class Out, class Answer>
void search_all(const char* function, std::span<const AnyRay> rays, const Bvh& bvh, std::span<Out> out,
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
      tasks.push_back(searches.emplace_back(rays[i], bvh, options.rule).task());
    }
    space::visit_triangles(bvh, tasks);
    for (std::size_t i = from; i < to; ++i) out[i] = answer(searches[i - from]);
  });
}

}  // namespace

using space::FirstHit, space::AnyHit, space::CountedHits, space::OrderedHits;

std::optional<NumberedHit> first_hit(const AnyRay& ray, const Bvh& bvh, HitRule rule) {
  return searched<FirstHit>("first_hit", ray, bvh, rule).first();
}
std::optional<std::uint32_t> first_triangle(const AnyRay& ray, const Bvh& bvh, HitRule rule) {
  return searched<FirstHit>("first_triangle", ray, bvh, rule).first_number();
}
bool hits(const AnyRay& ray, const Bvh& bvh, HitRule rule) { return searched<AnyHit>("hits", ray, bvh, rule).found(); }
std::vector<NumberedHit> ordered_hits(const AnyRay& ray, const Bvh& bvh, HitRule rule) {
  return searched<OrderedHits>("ordered_hits", ray, bvh, rule).in_order();
}
std::size_t count_hits(const AnyRay& ray, const Bvh& bvh, HitRule rule) {
  return searched<CountedHits>("count_hits", ray, bvh, rule).count();
}

void first_hits(std::span<const AnyRay> rays, const Bvh& bvh, std::span<std::optional<NumberedHit>> out,
                const ManyRays& options) {
  search_all<FirstHit>("first_hits", rays, bvh, out, options, [](const FirstHit& s) { return s.first(); });
}
void first_triangles(std::span<const AnyRay> rays, const Bvh& bvh, std::span<std::uint32_t> out,
                     const ManyRays& options) {
  search_all<FirstHit>("first_triangles", rays, bvh, out, options,
                       [](const FirstHit& s) { return s.first_number().value_or(no_triangle); });
}
void hits(std::span<const AnyRay> rays, const Bvh& bvh, std::span<std::uint8_t> out, const ManyRays& options) {
  search_all<AnyHit>("hits", rays, bvh, out, options,
                     [](const AnyHit& s) { return static_cast<std::uint8_t>(s.found() ? 1 : 0); });
}
void ordered_hits(std::span<const AnyRay> rays, const Bvh& bvh, std::span<std::vector<NumberedHit>> out,
                  const ManyRays& options) {
  search_all<OrderedHits>("ordered_hits", rays, bvh, out, options, [](OrderedHits& s) { return s.in_order(); });
}
void count_hits(std::span<const AnyRay> rays, const Bvh& bvh, std::span<std::size_t> out, const ManyRays& options) {
  search_all<CountedHits>("count_hits", rays, bvh, out, options, [](CountedHits& s) { return s.count(); });
}

}  // namespace plumb
