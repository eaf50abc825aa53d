// Two triangles in space: both cross the line of their planes in an interval, and the intervals are compared by signs
// of their corners alone.  Source: Guigue and Devillers 2003; RTCD 5.2.10.
#include <optional>

#include "overlap_linear3.hpp"
#include "overlap_parts.hpp"
#include "plumb/query/overlap_triangle.hpp"

namespace plumb {
namespace query {
namespace {

using Sides = std::array<Sign, 3>;

// Of the corners of one triangle over the plane of the other: positive on the side of its normal.
struct Crossing {
  std::size_t alone;  // the corner whose two edges cross the plane
  Sign above;         // is it above the plane?  It may be on it, with both others below or above.
  bool through;       // are there corners above and below?
};

// For sides that are neither all equal.
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

Sides sides(const Triangle3& of, const Triangle3& t) {
  return {-orient3d(t.a, t.b, t.c, of.a), -orient3d(t.a, t.b, t.c, of.b), -orient3d(t.a, t.b, t.c, of.c)};
}

// The corner alone, and the ends of its two edges in the order in which they cross the line of the planes.
struct Fan {
  const Point3 *tip, *first, *second;
};
Fan fan(const Triangle3& t, const Crossing& c) {
  const std::array corners{&t.a, &t.b, &t.c};
  const Point3 *next = corners[(c.alone + 1) % 3], *last = corners[(c.alone + 2) % 3];
  return c.above == Sign::positive ? Fan{corners[c.alone], next, last} : Fan{corners[c.alone], last, next};
}

Relation in_common_plane(const Triangle3& a, const Triangle3& b) {
  const std::size_t k = telling_axis(b);
  if (k == 3) return relate(flattened(b), a);
  const Triangle2 flat = seen(a, k);
  if (orient2d(flat.a, flat.b, flat.c) == Sign::zero) return relate(flattened(a), b);
  return relate(flat, seen(b, k));
}

}  // namespace

Relation relate(const Triangle3& a, const Triangle3& b) {
  const Sides of_a = sides(a, b);
  if (apart(of_a)) return Relation::disjoint;
  const Sides of_b = sides(b, a);
  if (apart(of_b)) return Relation::disjoint;
  if (all_are(of_a, Sign::zero) || all_are(of_b, Sign::zero)) return in_common_plane(a, b);
  const Crossing at_a = crossing(of_a), at_b = crossing(of_b);
  const Fan p = fan(a, at_a), q = fan(b, at_b);
  const Sign turned = at_a.above * at_b.above;
  const Sign starts = turned * orient3d(*p.tip, *p.first, *q.tip, *q.first);
  if (starts == Sign::negative) return Relation::disjoint;
  const Sign ends = -(turned * orient3d(*p.tip, *p.second, *q.tip, *q.second));
  const Sign all = least(starts, ends);
  return all == Sign::positive && !(at_a.through && at_b.through) ? Relation::touching : relation(all);
}

}  // namespace query

Relation relate(const Triangle3& a, const Triangle3& b) {
  query::require_shapes(a, b);
  return query::relate(a, b);
}

}  // namespace plumb
