#include "query/overlap/linear3.hpp"

#include <tuple>

#include "plumb/certify/coplanar.hpp"
#include "plumb/certify/line_triangle.hpp"
#include "plumb/predicates/cross_products.hpp"
#include "plumb/predicates/line_triangle.hpp"

namespace plumb::query {
namespace {

// The sign of (direction of a) x (direction of b) . (b.p - a.p).
Sign twist(const Linear3& a, const Linear3& b) {
  if (a.by_points && b.by_points) return orient3d(a.p, a.q, b.p, b.q);
  if (b.by_points) return line_edge(a.p, a.direction(), b.p, b.q);
  if (a.by_points) return line_edge(b.p, b.direction(), a.p, a.q);
  return sign_of(predicates::OrderAlongCross{}, a.direction(), b.direction(), a.p, b.p);
}

Linear3 whole_line(Linear3 a) {
  a.reach = LinearKind::line;
  return a;
}

// Of a point and what is not one.
Relation relate(const Point3& p, const Linear3& b) {
  if (b.is_point()) return p == b.p ? Relation::overlapping : Relation::disjoint;
  const Linear3 line = whole_line(b);
  for (std::size_t k = 0; k < 3; ++k) {
    if (query::relate(seen(p, k), line.seen_along(k)) == Relation::disjoint) return Relation::disjoint;
  }
  const std::size_t k = b.seen_along(2).is_point() ? 0 : 2;
  return query::relate(seen(p, k), b.seen_along(k));
}

// Along the normal of a, b, c.
Sign height(const Triangle3& t, const Point3& p) { return -orient3d(t.a, t.b, t.c, p); }
Sign rise(const Triangle3& t, const Linear3& l) {
  return l.by_points ? sign_of(predicates::OrientSeenAlong{}, l.p, l.q, t.a, t.b, t.c)
                     : orient_seen_from(l.direction(), t.a, t.b, t.c);
}
Sign pass(const Linear3& l, const Point3& a, const Point3& b) {
  return l.by_points ? orient3d(l.p, l.q, a, b) : line_edge(l.p, l.direction(), a, b);
}

Relation in_plane(const Linear3& a, const Triangle3& b) {
  const std::size_t k = telling_axis(b);
  return k == 3 ? relate(a, flattened(b)) : relate(a.seen_along(k), seen(b, k));
}

}  // namespace

std::size_t likely_axis(const Triangle3& t) {
  const double ux = t.b.x - t.a.x, uy = t.b.y - t.a.y, uz = t.b.z - t.a.z;
  const double vx = t.c.x - t.a.x, vy = t.c.y - t.a.y, vz = t.c.z - t.a.z;
  return axis_across(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx);
}

std::size_t telling_axis(const Triangle3& t) {
  const std::size_t first = likely_axis(t);
  for (const std::size_t k : {first, (first + 1) % 3, (first + 2) % 3}) {
    const Triangle2 flat = seen(t, k);
    if (orient2d(flat.a, flat.b, flat.c) != Sign::zero) return k;
  }
  return 3;
}

Linear3 flattened(const Triangle3& t) {
  const auto precedes = [](const Point3& a, const Point3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  };
  const auto [least, most] = std::minmax({t.a, t.b, t.c}, precedes);
  return Linear3::through(LinearKind::segment, least, most);
}

Relation relate(const Linear3& a, const Linear3& b) {
  if (a.is_point()) return relate(a.p, b);
  if (b.is_point()) return relate(b.p, a);
  for (std::size_t k = 0; k < 3; ++k) {
    if (turn(a.seen_along(k), b.seen_along(k)) == Sign::zero) continue;
    return twist(a, b) == Sign::zero ? relate(a.seen_along(k), b.seen_along(k)) : Relation::disjoint;
  }
  if (relate(b.p, whole_line(a)) == Relation::disjoint) return Relation::disjoint;
  const std::size_t k = a.seen_along(2).is_point() ? 0 : 2;
  return relate(a.seen_along(k), b.seen_along(k));
}

Relation relate(const Linear3& a, const Triangle3& b) {
  const Sign from = height(b, a.p);
  Sign along = Sign::zero, reaches = Sign::positive;
  if (a.is_point()) return from == Sign::zero ? in_plane(a, b) : Relation::disjoint;
  if (a.reach == LinearKind::segment) {
    const Sign to = height(b, a.q);
    reaches = -(from * to);
    if (reaches == Sign::negative) return Relation::disjoint;
    along = order(static_cast<double>(to), static_cast<double>(from));
  } else {
    along = rise(b, a);
    if (a.reach == LinearKind::ray) reaches = -(from * along);
    if (reaches == Sign::negative) return Relation::disjoint;
  }
  if (along == Sign::zero) return from == Sign::zero ? in_plane(a, b) : Relation::disjoint;
  Sign all = reaches;
  all = least(all, -(along * pass(a, b.a, b.b)));
  if (all != Sign::negative) all = least(all, -(along * pass(a, b.b, b.c)));
  if (all != Sign::negative) all = least(all, -(along * pass(a, b.c, b.a)));
  return relation(all);
}

}  // namespace plumb::query
