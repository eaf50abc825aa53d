// Triangle-triangle test, signed volumes: how do two triangles in space lie to one another, by the signs of volumes and
// areas of their corners?
//
// Where both cross the line of their planes, each does so in an interval, and the ends of intervals are compared by the
// volume of the edges that they lie on.  In one plane the edges are the axes that can separate.
// `Signs` has the corners of a as 0, 1, 2 and of b as 3, 4, 5: sides(i, j) gives the signs of corners j, j + 1, j + 2
// over the plane of i, i + 1, i + 2, volume(i, j, k, l) is orient3d.  As seen along an axis, areas has all of one plane
// and turn_of_b the second triangle's; axes are those to look along, in turn, and running_axis is asked where no axis
// shows b with an area: one in which the line runs that all corners lie on.
//
// Laws: exact where the signs are; nothing for triangles without area, unless they are apart or of one line.
// Source: Guigue and Devillers 2003; RTCD 5.2.10.
// Cost: six to eight volumes; in one plane three and all areas.
#pragma once

#include <array>
#include <bit>
#include <optional>

#include "query/overlap/flat_areas.hpp"
#include "query/overlap/lattice_points.hpp"
#include "query/overlap/linear3.hpp"
#include "query/overlap/quick2.hpp"

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

/// Doubles first: in a plane little is degenerate that is not so in space.
template <class Signs>
std::optional<Relation> relate_in_plane(const Triangle3& a, const Triangle3& b, const Signs& signs) {
  if constexpr (Signs::doubles_first) {
    const std::size_t likely = likely_axis(a);
    if (const auto answer = by_doubles(seen(a, likely), seen(b, likely))) return answer;
  }
  for (const std::size_t axis : signs.axes()) {
    if (signs.turn_of_b(axis) == Sign::zero) continue;
    const TriangleAreas<double> areas = signs.areas(axis);
    if (areas.of_a == 0) return {};
    return relation(sign_of_number(depth(areas)));
  }
  if (const std::optional<std::size_t> axis = signs.running_axis()) {
    using Corners = std::array<double, 9>;
    return relate_straight<3>(std::bit_cast<Corners>(a), std::bit_cast<Corners>(b), *axis);
  }
  return {};
}

template <class Signs>
std::optional<Relation> relate_by(const Triangle3& a, const Triangle3& b, const Signs& signs) {
  const Sides of_a = signs.sides(3, 0);
  if (apart(of_a)) return Relation::disjoint;
  if (all_are(of_a, Sign::zero)) return relate_in_plane(a, b, signs);
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
