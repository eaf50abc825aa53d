#include "query/contact/aim.hpp"

#include <algorithm>

#include "query/penetration/cached_guess.hpp"
#include "query/penetration/quick_axis.hpp"
#include "query/separation/corner_search.hpp"
#include "query/separation/proved_corners.hpp"

namespace plumb::query::touching {
namespace {

/// From a guess on, of which three corners start the search: it ends where there are four.
parting::CoreDistance core_distance(const Difference& d, DifferenceCorners guess) {
  if (guess.size > 0) {
    guess.size = std::min<std::size_t>(guess.size, 3);
    std::uint32_t rounds = 0;
    if (const auto proved = proved_nearest(d.a, d.b, guessed_nearest(d.a, d.b, guess, rounds))) {
      return {proved->corners, proved->meets};
    }
  }
  return parting::core_distance(d);
}

Aim aim_of(const parting::Parting& p) {
  return {.way = p.way, .at = p.way.from(), .are_apart = p.cores_are_apart, .all = p.level, .do_touch = p.cores_touch};
}
Aim aim_of(const parting::SumParting& s) {
  const bool are_apart = s.known == parting::SumParting::Known::apart;
  return {.way = s.parting->way,
          .at = {s.level[0].first, s.level[1].first},
          .are_apart = are_apart,
          .level = s.level,
          .is_proved = !are_apart,
          .is_widest = s.is_widest,
          .do_touch = s.parting->cores_touch};
}

}  // namespace

std::optional<Aim> cached_aim(const Difference& d, const ContactCache& cache) {
  if (!cache.has_edges || !d.a.is_sum() || !d.b.is_sum()) return {};
  const auto& [p, q] = cache.edges;
  const auto s = parting::plane_across(d, {{{p[0], p[1]}, {q[0], q[1]}}});
  if (!s) return {};
  return aim_of(*s);
}

Aim aim_at(const Difference& d, Guess guess, ContactCache* cache) {
  if (cache != nullptr) cache->has_edges = false;
  if (d.a.is_sum() && d.b.is_sum()) {
    using Known = parting::SumParting::Known;
    const parting::Gap gap = guess == Guess::likely ? parting::Gap::likely : parting::Gap::widest;
    const parting::SumParting s = parting::parted_sums(d, gap);
    if (s.known == Known::parting) return aim_of(s);
    if (guess != Guess::none && s.parting) {
      if (cache != nullptr && s.edges) {
        const auto [p, q] = *s.edges;
        cache->edges = {{{p.body, p.bit}, {q.body, q.bit}}}, cache->has_edges = true;
      }
      return aim_of(s);
    }
  }
  const DifferenceCorners before = parting::guess_of(d, cache);
  std::optional<parting::Parting> p = parting::parted_as_before(d, before);
  if (!p) {
    const parting::CoreDistance core = core_distance(d, before);
    parting::keep(cache, core.nearest);
    p = parting::parted_from(d, core);
  }
  parting::keep(cache, d, *p);
  return aim_of(*p);
}

}  // namespace plumb::query::touching
