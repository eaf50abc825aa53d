#include "plumb/space/ray/mesh_ray.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "query/ray/numbers.hpp"
#include "query/ray/posed_barycentric.hpp"
#include "space/bvh/equal_lengths.hpp"
#include "space/bvh/mesh_source.hpp"
#include "space/bvh/parts.hpp"
#include "space/bvh/slot_triangles.hpp"
#include "space/ray/hit_search.hpp"
#include "space/ray/packet_task.hpp"
#include "space/ray/ray_order.hpp"
#include "space/ray/unseen_ray.hpp"

namespace plumb {
namespace {

// So many are ordered, and of these so many searched for together; fewer under a pose, where each takes longer.
template <class Source>
constexpr std::size_t rays_of_part = space::is_posed_source<Source> ? 64 : 2048;
constexpr std::size_t rays_of_block = 256;

/// `ray`: which of many has these limits, if there are many.
void require_numbers(const char* function, const HitLimits& limits, std::optional<std::size_t> ray = {}) {
  for (const auto& [name, number] : {std::pair("least", limits.least), std::pair("most", limits.most)}) {
    if (!std::isnan(number)) continue;
    const std::string of = ray ? "[" + std::to_string(*ray) + "]" : "";
    throw NonFinite(std::string(function) + ": limits" + of + "." + name + " is NaN");
  }
}

/// answer(the search along the ray).
template <class Search, class Answer>
auto searched(const char* function, const MeshView& view, const AnyRay& ray, HitRule rule, const HitLimits* limits,
              const Answer& answer) {
  if (!query::is_sound(ray)) [[unlikely]]
    query::require_ray(function, ray);
  if (limits != nullptr) require_numbers(function, *limits);
  return space::with_source(function, "mesh", view, [&]<class Source>(const Source& source) {
    if constexpr (space::is_posed_source<Source>) {
      const auto seen = space::Sight(source)(ray);
      if (!seen) {
        Search search(ray, source, rule);
        if (limits != nullptr) search.keep_within(*limits);
        space::visit_unseen(source, ray, search);
        return answer(search);
      }
      Search search(ray, *seen, source, rule);
      if (limits != nullptr) search.keep_within(*limits);
      const space::RayTask task = search.task(seen->slabs);
      space::visit_triangles(source.bvh, {&task, 1});
      return answer(search);
    } else {
      const RaySlabs slabs(ray, source.tree.frame, source.tree.box());
      Search search(ray, slabs.keys(), source, rule);
      if (limits != nullptr) search.keep_within(*limits);
      const space::RayTask task = search.task(slabs);
      space::visit_triangles(source, {&task, 1});
      return answer(search);
    }
  });
}

/// One of many: the ray, and its limits where it has some.
struct AskedOf {
  const AnyRay* ray;
  const HitLimits* limits;
};

template <class Search>
Search& begun(Search& search, const AskedOf& of) {
  if (of.limits != nullptr) search.keep_within(*of.limits);
  return search;
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
  void add(std::span<const AskedOf> rays) {
    space::PacketTask& packet = packets_[packed_];
    std::array<const AnyRay*, space::packet_size> plain;
    for (std::size_t i = 0; i < rays.size(); ++i) plain[i] = rays[i].ray;
    if (are_near_ && space::put_plainly(std::span(plain).first(rays.size()), frame_, box_, packet.planes)) {
      packet.size = rays.size();
      for (std::size_t i = 0; i < rays.size(); ++i) {
        const RaySlabs::Keys& keys = query::ends(*rays[i].ray) ? space::plain_segment : space::plain_ray;
        Search& search = begun(searches_.emplace_back(*rays[i].ray, keys, mesh_, rule_), rays[i]);
        search.ask(packet.asked[i]);
        packet.limits[i] = search.limit();
      }
      if (++packed_ == packets_.size()) run_packets();
      return;
    }
    for (const AskedOf& of : rays) {
      const RaySlabs slabs(*of.ray, frame_, box_);
      others_.push_back(begun(searches_.emplace_back(*of.ray, slabs.keys(), mesh_, rule_), of).task(slabs));
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

/// Under a pose those that the mesh sees by turns, the others at once.
template <class Search, class Mesh>
class Searches<Search, PosedMeshOf<Mesh>> {
 public:
  Searches(const PosedMeshOf<Mesh>& mesh, HitRule rule, std::size_t most, bool are_near)
      : mesh_(mesh), sight_(mesh), rule_(rule), are_near_(are_near) {
    searches_.reserve(most), seen_.reserve(most);
  }

  void add(std::span<const AskedOf> rays) {
    for (const AskedOf& of : rays) {
      if (const auto seen = sight_(*of.ray)) {
        const space::SeenRay& kept = seen_.emplace_back(*seen);
        tasks_.push_back(begun(searches_.emplace_back(*of.ray, kept, mesh_, rule_), of).task(kept.slabs));
      } else {
        space::visit_unseen(mesh_, *of.ray, begun(searches_.emplace_back(*of.ray, mesh_, rule_), of));
      }
    }
  }
  void run() { space::visit_triangles(mesh_.bvh, tasks_, are_near_); }
  Search& operator[](std::size_t i) { return searches_[i]; }

 private:
  const PosedMeshOf<Mesh>& mesh_;
  space::Sight sight_;
  HitRule rule_;
  bool are_near_;
  std::vector<Search> searches_;  // which stay where they are, as what they refer to
  std::vector<space::SeenRay> seen_;
  std::vector<space::RayTask> tasks_;
};

/// out[i] = answer(the search along rays[i]); a block's rays descend together.
template <class Search, class Out, class Answer>
void search_all(const char* function, const MeshView& view, std::span<const AnyRay> rays, std::span<Out> out,
                const ManyRays& options, const Answer& answer) {
  space::require_equal_lengths(function, "out", out.size(), "rays", rays.size());
  if (!options.limits.empty())
    space::require_equal_lengths(function, "limits", options.limits.size(), "rays", rays.size());
  for (std::size_t i = 0; i < options.limits.size(); ++i) require_numbers(function, options.limits[i], i);
  space::with_source(function, "mesh", view, [&]<class Source>(const Source& source) {
    constexpr std::size_t part_size = rays_of_part<Source>;
    const auto& tree = space::mesh_of(source).tree;
    const auto [min, max] = tree.box();
    const Aabb3 box = space::box_of_node(source, BoxNode{min, 0, max, 0});
    const std::size_t parts = space::blocks_of(rays.size(), part_size);
    space::for_parts(function, options.execution, options.progress, parts, [&](std::size_t part) {
      const std::size_t begin = part * part_size;
      const auto asked = rays.subspan(begin, std::min(part_size, rays.size() - begin));
      for (const AnyRay& ray : asked) {
        if (!query::is_sound(ray)) query::require_ray(function, ray);
      }
      const auto [order, are_near] = space::order_of(asked, box, space::mesh_of(source).slots());
      for (std::size_t from = 0; from < asked.size(); from += rays_of_block) {
        const std::size_t to = std::min(asked.size(), from + rays_of_block);
        Searches<Search, Source> searches(source, options.rule, to - from, are_near);
        for (std::size_t i = from; i < to;) {
          std::array<AskedOf, space::packet_size> next;
          std::size_t n = 0;
          for (; n < next.size() && i < to; ++i) {
            const std::size_t at = order[i];
            next[n++] = {&asked[at], options.limits.empty() ? nullptr : &options.limits[begin + at]};
          }
          searches.add(std::span<const AskedOf>(next).first(n));
        }
        searches.run();
        for (std::size_t i = from; i < to; ++i) out[begin + order[i]] = answer(searches[i - from]);
      }
    });
  });
}

using space::FirstHit, space::AnyHit, space::CountedHits, space::OrderedHits, space::PassedTriangles;

constexpr auto first_of = [](const FirstHit& s) { return s.first(); };
constexpr auto first_number_of = [](const FirstHit& s) { return s.first_number(); };
constexpr auto first_number_or_none = [](const FirstHit& s) { return s.first_number().value_or(no_triangle); };
constexpr auto is_found = [](const AnyHit& s) { return s.found(); };
constexpr auto is_found_byte = [](const AnyHit& s) { return static_cast<std::uint8_t>(s.found() ? 1 : 0); };
constexpr auto all_of = [](OrderedHits& s) { return s.in_order(); };
constexpr auto count_of = [](CountedHits& s) { return s.count(); };

}  // namespace

std::optional<NumberedHit> first_hit(const MeshView& mesh, const AnyRay& ray, HitRule rule) {
  return searched<FirstHit>("first_hit", mesh, ray, rule, nullptr, first_of);
}
std::optional<std::uint32_t> first_triangle(const MeshView& mesh, const AnyRay& ray, HitRule rule) {
  return searched<FirstHit>("first_triangle", mesh, ray, rule, nullptr, first_number_of);
}
bool any_hit(const MeshView& mesh, const AnyRay& ray, HitRule rule) {
  return searched<AnyHit>("any_hit", mesh, ray, rule, nullptr, is_found);
}
std::vector<NumberedHit> hits(const MeshView& mesh, const AnyRay& ray, HitRule rule, std::vector<NumberedHit> rows) {
  return searched<OrderedHits>("hits", mesh, ray, rule, nullptr,
                               [&](OrderedHits& s) { return s.in_order(std::move(rows)); });
}
std::size_t count_hits(const MeshView& mesh, const AnyRay& ray, HitRule rule) {
  return searched<CountedHits>("count_hits", mesh, ray, rule, nullptr, count_of);
}

std::optional<NumberedHit> first_hit(const MeshView& mesh, const AnyRay& ray, const HitLimits& limits, HitRule rule) {
  return searched<FirstHit>("first_hit", mesh, ray, rule, &limits, first_of);
}
std::optional<std::uint32_t> first_triangle(const MeshView& mesh, const AnyRay& ray, const HitLimits& limits,
                                            HitRule rule) {
  return searched<FirstHit>("first_triangle", mesh, ray, rule, &limits, first_number_of);
}
bool any_hit(const MeshView& mesh, const AnyRay& ray, const HitLimits& limits, HitRule rule) {
  return searched<AnyHit>("any_hit", mesh, ray, rule, &limits, is_found);
}
std::vector<NumberedHit> hits(const MeshView& mesh, const AnyRay& ray, const HitLimits& limits, HitRule rule,
                              std::vector<NumberedHit> rows) {
  return searched<OrderedHits>("hits", mesh, ray, rule, &limits,
                               [&](OrderedHits& s) { return s.in_order(std::move(rows)); });
}
std::size_t count_hits(const MeshView& mesh, const AnyRay& ray, const HitLimits& limits, HitRule rule) {
  return searched<CountedHits>("count_hits", mesh, ray, rule, &limits, count_of);
}

void first_hit(const MeshView& mesh, std::span<const AnyRay> rays, std::span<std::optional<NumberedHit>> out,
               const ManyRays& options) {
  search_all<FirstHit>("first_hit", mesh, rays, out, options, first_of);
}
void first_triangle(const MeshView& mesh, std::span<const AnyRay> rays, std::span<std::uint32_t> out,
                    const ManyRays& options) {
  search_all<FirstHit>("first_triangle", mesh, rays, out, options, first_number_or_none);
}
void any_hit(const MeshView& mesh, std::span<const AnyRay> rays, std::span<std::uint8_t> out, const ManyRays& options) {
  search_all<AnyHit>("any_hit", mesh, rays, out, options, is_found_byte);
}
void hits(const MeshView& mesh, std::span<const AnyRay> rays, std::span<std::vector<NumberedHit>> out,
          const ManyRays& options) {
  search_all<OrderedHits>("hits", mesh, rays, out, options, all_of);
}
void count_hits(const MeshView& mesh, std::span<const AnyRay> rays, std::span<std::size_t> out,
                const ManyRays& options) {
  search_all<CountedHits>("count_hits", mesh, rays, out, options, count_of);
}

std::optional<HitBarycentric> hit_barycentric(const MeshView& mesh, const AnyRay& ray, std::uint32_t triangle) {
  return searched<PassedTriangles>("hit_barycentric", mesh, ray, HitRule::closed, nullptr,
                                   [&](const PassedTriangles& s) { return s.barycentric(triangle); });
}
std::optional<ExactHitBarycentric> exact_hit_barycentric(const MeshView& mesh, const AnyRay& ray,
                                                         std::uint32_t triangle) {
  return searched<PassedTriangles>("exact_hit_barycentric", mesh, ray, HitRule::closed, nullptr,
                                   [&](const PassedTriangles& s) { return s.exact_barycentric(triangle); });
}
void hit_barycentric(const MeshView& mesh, std::span<const AnyRay> rays, std::span<const std::uint32_t> triangles,
                     std::span<std::optional<HitBarycentric>> out, Execution execution) {
  constexpr const char* function = "hit_barycentric";
  space::require_equal_lengths(function, "triangles", triangles.size(), "rays", rays.size());
  space::require_equal_lengths(function, "out", out.size(), "rays", rays.size());
  space::with_source(function, "mesh", mesh, [&]<class Source>(const Source& source) {
    const auto& bvh = space::mesh_of(source);
    const space::SlotTriangles in_slots(bvh);
    // A descent takes as long as some hundreds of slots do in a pass.
    const bool are_many = rays.size() >= bvh.slots() / 256;
    const std::vector<std::uint32_t> slots = are_many ? space::slots_of(bvh) : std::vector<std::uint32_t>();
    const auto answer = [&](std::size_t i) -> std::optional<HitBarycentric> {
      if (!query::is_sound(rays[i])) query::require_ray(function, rays[i]);
      if (triangles[i] == no_triangle) return {};
      if (!are_many) return hit_barycentric(mesh, rays[i], triangles[i]);
      if (triangles[i] >= slots.size()) return {};
      const std::size_t slot = slots[triangles[i]];
      if constexpr (space::is_posed_source<Source>) {
        return query::hit_barycentric(rays[i], PosedTriangle{in_slots.triangle(slot), source.pose});
      } else {
        return query::hit_barycentric(rays[i], query::standing(in_slots.triangle(slot)));
      }
    };
    space::for_blocks(execution, rays.size(), 256, [&](std::size_t, std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i) out[i] = answer(i);
    });
  });
}

}  // namespace plumb
