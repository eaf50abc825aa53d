// Triangle and box tests: how do triangles and axis-aligned boxes in the plane lie to what is straight, and to one
// another?
//
// By the axes that can separate them: the normals of all sides.  Triangles and boxes without interior are what they
// are, segments and points.
// Source: RTCD 5.2.1, 5.2.10.
// Cost: up to 18 signs of degree 2.
#pragma once

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/simplex.hpp"
#include "query/overlap/linear2.hpp"

namespace plumb::query {

Relation relate(const Linear2& a, const Triangle2& b);
Relation relate(const Linear2& a, const Aabb2& b);
Relation relate(const Triangle2& a, const Triangle2& b);
Relation relate(const Triangle2& a, const Aabb2& b);

/// The same along the normal of the line alone, or of the triangle's edges; positive where that is zero.
inline Sign across(const Linear2& a, const Aabb2& box) {
  if (a.is_point()) return Sign::positive;
  const bool up = a.heads_x() != Sign::negative, left = a.heads_y() != Sign::negative;
  const auto& [min, max] = box;
  const Sign high = a.side({left ? min.x : max.x, up ? max.y : min.y});
  if (high != Sign::positive) return high;
  return -a.side({left ? max.x : min.x, up ? min.y : max.y});
}
Sign across(const Triangle2& a, Sign turns, const Aabb2& box);

/// Along an axis of a box: of the range that the other set has there.
constexpr Sign in_range(double low, double high, double from, double to) {
  return least(order(high, from), order(to, low));
}

}  // namespace plumb::query
