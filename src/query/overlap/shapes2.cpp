#include "query/overlap/shapes2.hpp"

#include <limits>
#include <utility>

namespace plumb::query {
namespace {

using TriangleCorners2 = std::array<Point2, 3>;

bool precedes(const Point2& a, const Point2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

// The segment or point that a triangle without area is.
Linear2 segment_of(const Triangle2& t) {
  const auto [least, most] = std::minmax({t.a, t.b, t.c}, precedes);
  return Linear2::through(LinearKind::segment, least, most);
}

Linear2 segment_of(const Aabb2& box) { return Linear2::through(LinearKind::segment, box.min, box.max); }

bool is_flat(const Aabb2& box) { return box.min.x == box.max.x || box.min.y == box.max.y; }

// Counterclockwise.
TriangleCorners2 corners(const Triangle2& t, Sign turns) {
  return turns == Sign::positive ? TriangleCorners2{t.a, t.b, t.c} : TriangleCorners2{t.a, t.c, t.b};
}

// Across the line of a, the points on both sides of it: positive where the line goes through what they span.
Sign between(Sign s, Sign t) { return least(most(s, t), -least(s, t)); }
Sign across(const Linear2& a, const TriangleCorners2& c) {
  if (a.is_point()) return Sign::positive;
  const Sign s = a.side(c[0]), t = a.side(c[1]);
  if (s * t == Sign::negative) return Sign::positive;
  const Sign u = a.side(c[2]);
  return between(most(most(s, t), u), least(least(s, t), u));
}

// How far into the inner side of an edge a reaches.
Sign beyond_edge(const Linear2& a, const Point2& from, const Point2& to) {
  if (a.reach == LinearKind::line && !a.is_point()) return Sign::positive;  // left to the line's own normal
  const Sign s = orient2d(from, to, a.p);
  if (s == Sign::positive || a.is_point()) return s;
  if (a.reach == LinearKind::segment) return most(s, orient2d(from, to, a.q));
  return turn(Linear2::through(LinearKind::segment, from, to), a) == Sign::positive ? Sign::positive : s;
}

Relation relate_corners(const Linear2& a, const TriangleCorners2& c) {
  Sign all = across(a, c);
  for (std::size_t i = 0; i < 3 && all != Sign::negative; ++i) all = least(all, beyond_edge(a, c[i], c[(i + 1) % 3]));
  return relation(all);
}

Sign beyond_edges(const TriangleCorners2& a, const TriangleCorners2& of) {
  Sign all = Sign::positive;
  for (std::size_t i = 0; i < 3 && all != Sign::negative; ++i) {
    const Point2 &from = of[i], &to = of[(i + 1) % 3];
    Sign here = orient2d(from, to, a[0]);
    if (here != Sign::positive) here = most(here, orient2d(from, to, a[1]));
    if (here != Sign::positive) here = most(here, orient2d(from, to, a[2]));
    all = least(all, here);
  }
  return all;
}

Sign within(const Linear2& a, const Aabb2& box) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (a.reach == LinearKind::line && !a.is_point()) return Sign::positive;
  const auto along = [&](double p, double q, Sign heads, double from, double to) {
    if (a.is_point()) return in_range(p, p, from, to);
    if (a.reach == LinearKind::segment) return in_range(std::min(p, q), std::max(p, q), from, to);
    return in_range(heads == Sign::negative ? -infinity : p, heads == Sign::positive ? infinity : p, from, to);
  };
  return least(along(a.p.x, a.q.x, a.heads_x(), box.min.x, box.max.x),
               along(a.p.y, a.q.y, a.heads_y(), box.min.y, box.max.y));
}

}  // namespace

Sign across(const Triangle2& a, Sign turns, const Aabb2& box) {
  if (turns == Sign::zero) return across(segment_of(a), box);
  const TriangleCorners2 c = corners(a, turns);
  Sign all = Sign::positive;
  for (std::size_t i = 0; i < 3 && all != Sign::negative; ++i) {
    const Point2 &from = c[i], &to = c[(i + 1) % 3];
    const Point2 inmost{from.y <= to.y ? box.min.x : box.max.x, from.x <= to.x ? box.max.y : box.min.y};
    all = least(all, orient2d(from, to, inmost));
  }
  return all;
}

Relation relate(const Linear2& a, const Triangle2& b) {
  const Sign turns = orient2d(b.a, b.b, b.c);
  return turns == Sign::zero ? relate(a, segment_of(b)) : relate_corners(a, corners(b, turns));
}

Relation relate(const Linear2& a, const Aabb2& b) {
  if (is_empty(b)) return Relation::disjoint;
  if (is_flat(b)) return relate(a, segment_of(b));
  const Sign along = within(a, b);
  return along == Sign::negative ? Relation::disjoint : relation(least(along, across(a, b)));
}

Relation relate(const Triangle2& a, const Triangle2& b) {
  const Sign of_a = orient2d(a.a, a.b, a.c), of_b = orient2d(b.a, b.b, b.c);
  if (of_a == Sign::zero) return relate(segment_of(a), b);
  if (of_b == Sign::zero) return relate(segment_of(b), a);
  const TriangleCorners2 p = corners(a, of_a), q = corners(b, of_b);
  const Sign first = beyond_edges(q, p);
  return first == Sign::negative ? Relation::disjoint : relation(least(first, beyond_edges(p, q)));
}

Relation relate(const Triangle2& a, const Aabb2& b) {
  if (is_empty(b)) return Relation::disjoint;
  if (is_flat(b)) return relate(segment_of(b), a);
  const auto [left, right] = std::minmax({a.a.x, a.b.x, a.c.x});
  const auto [low, high] = std::minmax({a.a.y, a.b.y, a.c.y});
  const Sign along = least(in_range(left, right, b.min.x, b.max.x), in_range(low, high, b.min.y, b.max.y));
  if (along == Sign::negative) return Relation::disjoint;
  return relation(least(along, across(a, orient2d(a.a, a.b, a.c), b)));
}

}  // namespace plumb::query
