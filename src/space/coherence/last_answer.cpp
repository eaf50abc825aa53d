// The searches of the functions without a memory, begun with a guess.
#include "plumb/space/coherence/last_answer.hpp"

#include "query/body/figure_input.hpp"
#include "query/ray/numbers.hpp"
#include "space/bvh/mesh_source.hpp"
#include "space/closest/closest_pair_search.hpp"
#include "space/closest/posed_nearest_search.hpp"
#include "space/pairs/pair_answers.hpp"
#include "space/pairs/pair_search.hpp"
#include "space/pairs/pair_sources.hpp"
#include "space/ray/hit_search.hpp"

namespace plumb {
namespace space {
namespace {

/// The pair of the last answer, where relate_slots says that it still meets; else any, by the search.
template <class Relate, class Search>
std::optional<TrianglePair> any_pair_from(const Bvh& a, const Bvh& b, LastPair& last, const PairOptions& options,
                                          const Relate& relate_slots, const Search& search) {
  if (last.slot_a < a.triangles.size() && last.slot_b < b.triangles.size()) {
    const Relation relation = relate_slots(last.slot_a, last.slot_b);
    if (relation == Relation::overlapping || (relation == Relation::touching && options.touching))
      return TrianglePair{a.tree.items[last.slot_a], b.tree.items[last.slot_b], relation};
  }
  SlotPair at{no_slot, no_slot};
  const auto found = any_pair(search, &at);
  if (found) last = {at.a, at.b};
  return found;
}

/// The pair of the last answer is offered first.
template <class Source>
std::optional<ClosestTriangles> closest_pair_from(Source a, Source b, LastPair& last,
                                                  const ClosestPairOptions& options) {
  if (a.bvh().slots() == 0 || b.bvh().slots() == 0 || !(options.within >= 0)) return {};
  ClosestSearch<Source> search(a, b, options);
  search.guess(last.slot_a, last.slot_b);
  const auto found = search.run();
  if (!found) return {};
  last = {found->slot_a, found->slot_b};
  return closest_pair_found(a, b, *found);
}

}  // namespace
}  // namespace space

std::optional<TrianglePair> any_intersecting_pair(const BvhView& a, const BvhView& b, LastPair& last,
                                                  const PairOptions& options) {
  constexpr const char* function = "any_intersecting_pair";
  return space::with_sources(function, a, b, [&]<class Source>(const Source& s, const Source& t) {
    const auto relate_slots = [&](std::uint32_t i, std::uint32_t k) {
      if constexpr (space::is_posed_source<Source>) {
        return query::relate(s.triangle(i), t.triangle(k));
      } else {
        return relate(s.triangle(i), t.triangle(k));
      }
    };
    return space::any_pair_from(space::mesh_of(s), space::mesh_of(t), last, options, relate_slots,
                                space::PairSearch(function, s, t, false, options));
  });
}

std::optional<ClosestOnMesh> closest_on_mesh(const BvhView& view, const Point3& p, LastTriangle& last) {
  query::require_figure("closest_on_mesh", "p", p);
  return space::with_source("closest_on_mesh", "mesh", view, [&](const auto& mesh) -> std::optional<ClosestOnMesh> {
    const auto found = space::Nearest<space::Unwatched, std::remove_cvref_t<decltype(mesh)>>(mesh, 1).of(p, last.slot);
    if (found.empty()) return {};
    last.slot = found[0].slot;
    return space::closest_found(mesh, p, found[0]);
  });
}

std::optional<ClosestTriangles> closest_triangles(const BvhView& a, const BvhView& b, LastPair& last,
                                                  const ClosestPairOptions& options) {
  const space::AskedPair asked("closest_triangles", a, b);
  if (asked.stand())
    return space::closest_pair_from(space::StandingSource(asked.a.bvh), space::StandingSource(asked.b.bvh), last,
                                    options);
  return space::closest_pair_from(space::PosedSource(asked.a), space::PosedSource(asked.b), last, options);
}

bool any_hit(const Bvh& bvh, const AnyRay& ray, LastTriangle& last, HitRule rule) {
  if (!query::is_sound(ray)) query::require_ray("any_hit", ray);
  if (last.slot < bvh.triangles.size() && hits(ray, bvh.triangle(last.slot), rule)) return true;
  const RaySlabs slabs(ray, bvh.tree);
  space::AnyHit search(ray, slabs.keys(), bvh, rule);
  const space::RayTask task = search.task(slabs);
  space::visit_triangles(bvh, {&task, 1});
  if (search.found()) last.slot = search.slot();
  return search.found();
}

}  // namespace plumb
