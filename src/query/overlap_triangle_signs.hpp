// How do two triangles in space lie to one another, by the signs of volumes and areas of their corners?
//
// Where both cross the line of their planes, each does so in an interval, and the ends of intervals are compared by the
// volume of the edges that they lie on.  In one plane the edges are the axes that can separate.
// `Signs` has the corners of a as 0, 1, 2 and of b as 3, 4, 5: sides(i, j) gives the signs of corners j, j + 1, j + 2
// over the plane of i, i + 1, i + 2, volume(i, j, k, l) is orient3d; seen_along(axis) has area(i, j, k), orient2d, and
// most_area, the most of those for three corners, times a sign.
//
// Laws: exact where the signs are; nothing for triangles without area, unless they are apart.
// Source: Guigue and Devillers 2003; RTCD 5.2.10.  Cost: six to eight volumes; in one plane up to 22 areas.
#pragma once

#include <array>
#include <optional>

#include "overlap_signs.hpp"

namespace plumb::query {

using Sides = std::array<Sign, 3>;

// Of the corners of one triangle over the plane of the other: positive on the side of its normal.
struct Crossing {
  std::size_t alone;  // the corner whose two edges cross the plane
  Sign above;         // is it above the plane?  It may be on it, with both others below or above.
  bool through;       // are there corners above and below?
};

// For sides that are not all equal.
constexpr Crossing crossing(const Sides& s) {
  const auto count = [&](Sign x) { return (s[0] == x) + (s[1] == x) + (s[2] == x); };
  const auto find = [&](Sign x) { return static_cast<std::size_t>(s[0] == x ? 0 : s[1] == x ? 1 : 2); };
  const int above = count(Sign::positive), below = count(Sign::negative);
  if (above == 2 && below == 0) return {find(Sign::zero), Sign::negative, false};
  if (below == 2 && above == 0) return {find(Sign::zero), Sign::positive, false};
  if (above == 1) return {find(Sign::positive), Sign::positive, below != 0};
  return {find(Sign::negative), Sign::negative, above != 0};
}

constexpr bool all_are(const Sides& s, Sign x) { return s[0] == x && s[1] == x && s[2] == x; }
constexpr bool apart(const Sides& s) { return s[0] != Sign::zero && all_are(s, s[0]); }

// The corner alone, and the ends of its two edges in the order in which they cross the line of the planes.
struct Fan {
  std::size_t tip, first, second;
};
constexpr Fan fan(std::size_t from, const Crossing& c) {
  const std::size_t next = from + (c.alone + 1) % 3, last = from + (c.alone + 2) % 3;
  return c.above == Sign::positive ? Fan{from + c.alone, next, last} : Fan{from + c.alone, last, next};
}

// How far the corners from, from + 1, from + 2 reach into the inner sides of the edges of those at `of`, which turn so.
template <class Areas>
Sign beyond_edges(const Areas& flat, std::size_t of, Sign turns, std::size_t from) {
  const auto at = [&](std::size_t p, std::size_t q) { return flat.most_area(of + p, of + q, from, turns); };
  return least(at(0, 1), least(at(1, 2), at(2, 0)));
}

template <class Signs>
std::optional<Relation> relate_in_plane(const Signs& signs) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto flat = signs.seen_along(axis);
    const Sign of_b = flat.area(3, 4, 5);
    if (of_b == Sign::zero) continue;
    const Sign of_a = flat.area(0, 1, 2);
    if (of_a == Sign::zero) return {};
    const Sign first = beyond_edges(flat, 0, of_a, 3);
    if (first == Sign::negative) return Relation::disjoint;
    return relation(least(first, beyond_edges(flat, 3, of_b, 0)));
  }
  return {};
}

template <class Signs>
std::optional<Relation> relate_by(const Signs& signs) {
  const Sides of_a = signs.sides(3, 0);
  if (apart(of_a)) return Relation::disjoint;
  if (all_are(of_a, Sign::zero)) return relate_in_plane(signs);
  const Sides of_b = signs.sides(0, 3);
  if (apart(of_b)) return Relation::disjoint;
  if (all_are(of_b, Sign::zero)) return {};  // a has no area
  const Crossing at_a = crossing(of_a), at_b = crossing(of_b);
  const Fan p = fan(0, at_a), q = fan(3, at_b);
  const Sign turned = at_a.above * at_b.above;
  const Sign starts = turned * signs.volume(p.tip, p.first, q.tip, q.first);
  if (starts == Sign::negative) return Relation::disjoint;
  const Sign all = least(starts, -(turned * signs.volume(p.tip, p.second, q.tip, q.second)));
  return all == Sign::positive && !(at_a.through && at_b.through) ? Relation::touching : relation(all);
}

}  // namespace plumb::query
