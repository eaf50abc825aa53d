#include "query/overlap/linear2.hpp"

#include <limits>

namespace plumb::query {
namespace {

// Of collinear ones along the axis in which the line runs.
ClosedRange range(const Linear2& a, bool along_x) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double p = along_x ? a.p.x : a.p.y, q = along_x ? a.q.x : a.q.y;
  if (a.is_point()) return {p, p};
  if (a.reach == LinearKind::line) return {-infinity, infinity};
  if (a.reach == LinearKind::segment) return {std::min(p, q), std::max(p, q)};
  const bool ahead = (along_x ? a.heads_x() : a.heads_y()) == Sign::positive;
  return ahead ? ClosedRange{p, infinity} : ClosedRange{-infinity, p};
}

// Where b's line is crossed on a, told by the sides of a's ends: positive in the relative interior.
Sign crossing(const Linear2& a, const Linear2& b, Sign turn_from_a) {
  if (a.reach == LinearKind::line) return Sign::positive;
  const Sign from = b.side(a.p) * turn_from_a;
  return a.reach == LinearKind::ray ? from : least(from, -(b.side(a.q) * turn_from_a));
}

}  // namespace

Sign turn(const Linear2& a, const Linear2& b) {
  if (a.by_points && b.by_points)
    return sign_of([](auto ax, auto ay, auto bx, auto by, auto cx, auto cy, auto dx,
                      auto dy) { return (bx - ax) * (dy - cy) - (by - ay) * (dx - cx); },
                   a.p, a.q, b.p, b.q);
  if (a.by_points) return -turn(b, a);
  const Vector2 d{a.q.x, a.q.y};
  if (b.by_points) return sign_of(CrossFrom{}, d, b.p, b.q);
  return sign_of(predicates::Cross2d{}, d, Vector2{b.q.x, b.q.y});
}

Relation relate(const Linear2& a, const Linear2& b) {
  if (a.is_point()) return relate(a.p, b);
  if (b.is_point()) return relate(b.p, a);
  const Sign turning = turn(a, b);
  if (turning != Sign::zero) {
    const Sign on_a = crossing(a, b, turning);
    return on_a == Sign::negative ? Relation::disjoint : relation(least(on_a, crossing(b, a, -turning)));
  }
  if (a.side(b.p) != Sign::zero) return Relation::disjoint;
  const bool along_x = a.heads_x() != Sign::zero;
  return relate_ranges(range(a, along_x), range(b, along_x));
}

Relation relate(const Point2& p, const Linear2& b) {
  if (b.is_point()) return p == b.p ? Relation::overlapping : Relation::disjoint;
  if (b.side(p) != Sign::zero) return Relation::disjoint;
  const bool along_x = b.heads_x() != Sign::zero;
  const double x = along_x ? p.x : p.y;
  return relate_ranges({x, x}, range(b, along_x));
}

}  // namespace plumb::query
