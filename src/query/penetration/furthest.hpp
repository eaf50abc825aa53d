// Extreme vertex: which corner of a body lies furthest along a direction, and which ones are level with it?  A guess in
// doubles, and the exact answers.
//
// Laws: of the guess nothing is certain.  What is exact is so whatever corner the search begins at.
// Source: RTCD 9.5.3, 9.5.4 (hill climbing).
// Cost: of boxes a sign a way, of polyhedra the way climbed, else linear in the corners.
#pragma once

#include "query/penetration/difference.hpp"
#include "query/penetration/short_list.hpp"

namespace plumb::query::parting {

/// A guess, from a corner that may be near.
std::uint32_t guessed_furthest(const CoreCorners& c, const arith::Plain& along, std::uint32_t from);

/// The sign of how much further corner i lies than another; `way` negative: against the normal.
template <class Of>
Sign further(const CoreCorners& c, Normal<Of>& normal, Sign way, std::uint32_t i, std::uint32_t from) {
  return way * sign_of([&]<class T>() -> T {
           return dot(normal.template as<T>(), c.template at<T>(i) - c.template at<T>(from));
         });
}
template <class Of>
Sign further_by_way(const CoreCorners& c, Normal<Of>& normal, Sign way, std::size_t k) {
  return way * sign_of([&]<class T>() -> T { return dot(normal.template as<T>(), c.template way<T>(k)); });
}

/// A corner that lies further than the first of those known to be level; nothing where none does.  Along a Normal, or
/// whatever else these two signs are told of.
template <class Along>
std::optional<std::uint32_t> any_further(const CoreCorners& c, Along& normal, Sign way, std::uint32_t from,
                                         const KnownLevel& known) {
  const auto is_further = [&](std::uint32_t i) {
    return !known.has(i) && further(c, normal, way, i, from) == Sign::positive;
  };
  if (c.polyhedron() != nullptr) {
    for (const std::uint32_t i : c.polyhedron()->neighbors_of(from)) {
      if (is_further(i)) return i;
    }
    return {};
  }
  if (c.ways() > 0) {
    std::uint32_t best = from;
    for (std::size_t k = 0; k < c.ways(); ++k) {
      const std::uint32_t bit = 1u << k;
      if (known.has(from ^ bit)) continue;
      const Sign along = further_by_way(c, normal, way, k);
      if (along != Sign::zero) best = along == Sign::positive ? best | bit : best & ~bit;
    }
    if (best == from) return {};
    return best;
  }
  for (std::uint32_t i = 0; i < c.size(); ++i) {
    if (is_further(i)) return i;
  }
  return {};
}

/// All corners than which none lies further, ascending; the search begins at the first of those known to be level.
/// `is_furthest`: none is further than that one, for certain.
using LevelCorners = ShortList<std::uint32_t, 16>;
template <class Along>
LevelCorners all_furthest(const CoreCorners& c, Along& normal, Sign way, std::uint32_t from, KnownLevel known,
                          bool is_furthest = false) {
  while (!is_furthest) {  // ends: each lies further
    const auto better = any_further(c, normal, way, from, known);
    is_furthest = !better;
    if (better) from = *better, known = KnownLevel(c, from);
  }
  LevelCorners level;
  if (c.ways() > 0) {
    std::uint32_t free = 0;
    for (std::size_t k = 0; k < c.ways(); ++k) {
      const std::uint32_t bit = 1u << k;
      if (known.has(from ^ bit) || !c.has_length(k) || further_by_way(c, normal, way, k) == Sign::zero) free |= bit;
    }
    for (std::uint32_t i = 0; i < c.size(); ++i) {
      if ((i & ~free) == (from & ~free)) level.push_back(i);
    }
    return level;
  }
  const auto is_level = [&](std::uint32_t i) { return known.has(i) || further(c, normal, way, i, from) == Sign::zero; };
  if (c.polyhedron() == nullptr) {
    for (std::uint32_t i = 0; i < c.size(); ++i) {
      if (is_level(i)) level.push_back(i);
    }
    return level;
  }
  LevelCorners below;     // those that were looked at
  level.push_back(from);  // what is level on a convex surface hangs together
  for (std::size_t k = 0; k < level.size(); ++k) {
    for (const std::uint32_t i : c.polyhedron()->neighbors_of(level[k])) {
      if (std::ranges::find(level, i) != level.end() || std::ranges::find(below, i) != below.end()) continue;
      (is_level(i) ? level : below).push_back(i);
    }
  }
  std::ranges::sort(level);
  return level;
}

/// The same where none lies further than the first of those known to be level; else nothing.  `is_below(i)`: whether a
/// corner is known to lie less far; what is not is asked.
template <class Along, class IsBelow>
std::optional<LevelCorners> level_corners(const CoreCorners& c, Along& normal, Sign way, std::uint32_t from,
                                          const KnownLevel& known, const IsBelow& is_below) {
  if (c.ways() > 0) {
    if (any_further(c, normal, way, from, known)) return {};
    return all_furthest(c, normal, way, from, known, true);
  }
  LevelCorners level;
  const auto is_passed = [&](std::uint32_t i) {  // false where it lies further
    if (is_below(i) || std::ranges::find(level, i) != level.end()) return true;
    const Sign s = known.has(i) ? Sign::zero : further(c, normal, way, i, from);
    if (s == Sign::zero) level.push_back(i);
    return s != Sign::positive;
  };
  constexpr std::size_t few = 12;  // all of so few are asked as soon as those beside the level ones
  if (c.polyhedron() == nullptr || c.size() <= few) {
    for (std::uint32_t i = 0; i < c.size(); ++i) {
      if (!is_passed(i)) return {};
    }
    return level;
  }
  level.push_back(from);  // what is level on a convex surface hangs together
  for (std::size_t k = 0; k < level.size(); ++k) {
    for (const std::uint32_t i : c.polyhedron()->neighbors_of(level[k])) {
      if (!is_passed(i)) return {};
    }
  }
  if (level.size() > 1) std::ranges::sort(level);
  return level;
}

}  // namespace plumb::query::parting
