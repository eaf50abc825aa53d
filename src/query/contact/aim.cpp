#include "query/contact/aim.hpp"

#include <algorithm>

#include "query/penetration/quick_axis.hpp"
#include "query/separation/corner_search.hpp"
#include "query/separation/proved_corners.hpp"

namespace plumb::query::touching {
namespace {

/// None that these bodies have not.
DifferenceCorners guess_of(const Difference& d, const ContactCache* cache) {
  DifferenceCorners guess;
  for (std::uint32_t i = 0; cache != nullptr && i < cache->size && i < cache->corners.size(); ++i) {
    const Ends& e = cache->corners[i];
    if (e[0] < d.a.size() && e[1] < d.b.size()) guess.add(e);
  }
  return guess;
}

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

}  // namespace

Aim aim_at(const Difference& d, bool may_guess, ContactCache* cache) {
  if (d.a.is_sum() && d.b.is_sum()) {
    using Known = parting::SumParting::Known;
    parting::SumParting s = parting::parted_sums(d);
    if (s.known == Known::apart && may_guess && !s.parting) s = parting::plane_between(d).value_or(s);
    if (s.known == Known::parting || (may_guess && s.parting)) {
      const bool are_apart = s.known == Known::apart;
      return {s.parting->way, {s.level[0].first, s.level[1].first}, are_apart, s.level, {}, !are_apart};
    }
  }
  const parting::CoreDistance core = core_distance(d, guess_of(d, cache));
  if (cache != nullptr) {
    cache->size = static_cast<std::uint32_t>(core.nearest.size);
    cache->corners = core.nearest.ends;
  }
  const parting::Parting p = parting::parted_from(d, core);
  return {p.way, p.way.from(), p.cores_are_apart, {}, p.level};
}

}  // namespace plumb::query::touching
