#include "plumb/space/ray/mesh_ray.hpp"

#include <algorithm>
#include <array>

#include "query/ray/numbers.hpp"
#include "space/bvh/blocks.hpp"
#include "space/bvh/equal_lengths.hpp"
#include "space/bvh/parts.hpp"
#include "space/ray/hit_search.hpp"
#include "space/ray/packet_task.hpp"
#include "space/ray/ray_order.hpp"

namespace plumb {
namespace {

// So many are ordered, and of these so many searched for together.
constexpr std::size_t rays_of_part = 2048, rays_of_block = 256;

/// answer(the search along the ray).
template <class Search, class Mesh, class Answer>
auto searched(const char* function, const AnyRay& ray, const Mesh& mesh, HitRule rule, const Answer& answer) {
  if (!query::is_sound(ray)) [[unlikely]]
    query::require_ray(function, ray);
  const RaySlabs slabs(ray, mesh.tree.frame, mesh.tree.box());
  Search search(ray, slabs.keys(), mesh, rule);
  const space::RayTask task = search.task(slabs);
  space::visit_triangles(mesh, {&task, 1});
  return answer(search);
}

/// Searches along rays that are taken down in packets where they are near one another, plain and fit, else by turns.
template <class Search, class Mesh>
class Searches {
 public:
  Searches(const Mesh& mesh, HitRule rule, std::size_t most, bool are_near)
      : mesh_(mesh), rule_(rule), are_near_(are_near), frame_(mesh.tree.frame), box_(mesh.tree.box()) {
    searches_.reserve(most);
  }

  /// At most a packet's size of them.
  void add(std::span<const AnyRay* const> rays) {
    space::PacketTask& packet = packets_[packed_];
    if (are_near_ && space::put_plainly(rays, frame_, box_, packet.planes)) {
      packet.size = rays.size();
      for (std::size_t i = 0; i < rays.size(); ++i) {
        const RaySlabs::Keys& keys = query::ends(*rays[i]) ? space::plain_segment : space::plain_ray;
        searches_.emplace_back(*rays[i], keys, mesh_, rule_).ask(packet.asked[i]);
        packet.limits[i] = keys.limit;
      }
      if (++packed_ == packets_.size()) run_packets();
      return;
    }
    for (const AnyRay* ray : rays) {
      const RaySlabs slabs(*ray, frame_, box_);
      others_.push_back(searches_.emplace_back(*ray, slabs.keys(), mesh_, rule_).task(slabs));
    }
  }
  void run() {
    run_packets();
    space::visit_triangles(mesh_, others_, are_near_);
  }
  Search& operator[](std::size_t i) { return searches_[i]; }

 private:
  void run_packets() {
    space::visit_triangles(mesh_, std::span<const space::PacketTask>(packets_).first(packed_));
    packed_ = 0;
  }

  const Mesh& mesh_;
  HitRule rule_;
  bool are_near_;
  BoxFrame frame_;
  FloatBox3 box_;
  std::vector<Search> searches_;  // which stay where they are
  std::array<space::PacketTask, space::packets_together> packets_;
  std::size_t packed_ = 0;
  std::vector<space::RayTask> others_;
};

/// out[i] = answer(the search along rays[i]); a block's rays descend together.
template <class Search, class Mesh, class Out, class Answer>
void search_all(const char* function, std::span<const AnyRay> rays, const Mesh& mesh, std::span<Out> out,
                const ManyRays& options, const Answer& answer) {
  space::require_equal_lengths(function, "out", out.size(), "rays", rays.size());
  const Aabb3 box = mesh.tree.frame.outside(mesh.tree.box());
  const std::size_t parts = space::blocks_of(rays.size(), rays_of_part);
  space::for_parts(function, options.execution, options.progress, parts, [&](std::size_t part) {
    const std::size_t begin = part * rays_of_part;
    const auto asked = rays.subspan(begin, std::min(rays_of_part, rays.size() - begin));
    for (const AnyRay& ray : asked) {
      if (!query::is_sound(ray)) query::require_ray(function, ray);
    }
    const auto [order, are_near] = space::order_of(asked, box, mesh.slots());
    for (std::size_t from = 0; from < asked.size(); from += rays_of_block) {
      const std::size_t to = std::min(asked.size(), from + rays_of_block);
      Searches<Search, Mesh> searches(mesh, options.rule, to - from, are_near);
      for (std::size_t i = from; i < to;) {
        std::array<const AnyRay*, space::packet_size> next;
        std::size_t n = 0;
        while (n < next.size() && i < to) next[n++] = &asked[order[i++]];
        searches.add(std::span<const AnyRay* const>(next).first(n));
      }
      searches.run();
      for (std::size_t i = from; i < to; ++i) out[begin + order[i]] = answer(searches[i - from]);
    }
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
  std::vector<NumberedHit> ordered_hits(const AnyRay& ray, const Mesh& mesh, HitRule rule,                          \
                                        std::vector<NumberedHit> rows) {                                            \
    return searched<OrderedHits>("ordered_hits", ray, mesh, rule,                                                   \
                                 [&](OrderedHits& s) { return s.in_order(std::move(rows)); });                      \
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
