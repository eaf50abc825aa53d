#include "query/overlap/shapes3.hpp"

#include <limits>

namespace plumb::query {
namespace {

using Numbers = std::array<double, 3>;

constexpr Numbers numbers(const Point3& p) { return {p.x, p.y, p.z}; }

// A box with an interior, or not flat along one axis alone, in which the other set extends.
enum class LevelKind : unsigned char { solid, in_plane, straight };
struct Flatness {
  LevelKind kind;
  std::size_t axis;  // of the plane
};
Flatness flatness(const Aabb3& box) {
  const std::array flat{box.min.x == box.max.x, box.min.y == box.max.y, box.min.z == box.max.z};
  const int count = flat[0] + flat[1] + flat[2];
  return {count == 0   ? LevelKind::solid
          : count == 1 ? LevelKind::in_plane
                       : LevelKind::straight,
          static_cast<std::size_t>(flat[0]   ? 0
                                   : flat[1] ? 1
                                             : 2)};
}
Linear3 segment_of(const Aabb3& box) { return Linear3::through(LinearKind::segment, box.min, box.max); }

Sign heads(const Linear3& a, std::size_t k) {
  return a.by_points ? order(numbers(a.q)[k], numbers(a.p)[k]) : order(numbers(a.q)[k], 0);
}

// Along the axes of the box.
Sign within(const Linear3& a, const Aabb3& box) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const bool is_point = a.is_point();
  if (a.reach == LinearKind::line && !is_point) return Sign::positive;
  Sign all = Sign::positive;
  for (std::size_t k = 0; k < 3; ++k) {
    const double p = numbers(a.p)[k], q = numbers(a.q)[k];
    const Sign ahead = heads(a, k);
    double low = p, high = p;
    if (a.reach == LinearKind::segment) {
      low = std::min(p, q), high = std::max(p, q);
    } else if (!is_point) {
      low = ahead == Sign::negative ? -infinity : p, high = ahead == Sign::positive ? infinity : p;
    }
    all = least(all, in_range(low, high, numbers(box.min)[k], numbers(box.max)[k]));
  }
  return all;
}

// Along the normal of the triangle.
Sign beside(const Triangle3& t, const std::array<Sign, 3>& normal, const Aabb3& box) {
  if (normal == std::array{Sign::zero, Sign::zero, Sign::zero}) return Sign::positive;
  const Sign high = -orient3d(t.a, t.b, t.c, corner(box, normal));
  if (high != Sign::positive) return high;
  return orient3d(t.a, t.b, t.c, corner(box, {-normal[0], -normal[1], -normal[2]}));
}

}  // namespace

Relation relate(const Linear3& a, const Aabb3& b) {
  if (is_empty(b)) return Relation::disjoint;
  if (const auto [kind, k] = flatness(b); kind != LevelKind::solid) {
    if (kind == LevelKind::straight) return relate(a, segment_of(b));
    if (heads(a, k) == Sign::zero) {
      return numbers(a.p)[k] == numbers(b.min)[k] ? relate(a.seen_along(k), seen(b, k)) : Relation::disjoint;
    }
  }
  Sign all = within(a, b);
  for (std::size_t k = 0; k < 3 && all != Sign::negative; ++k) all = least(all, across(a.seen_along(k), seen(b, k)));
  return relation(all);
}

Relation relate(const Triangle3& a, const Aabb3& b) {
  if (is_empty(b)) return Relation::disjoint;
  Numbers low{}, high{};
  Sign all = Sign::positive;
  for (std::size_t k = 0; k < 3; ++k) {
    std::tie(low[k], high[k]) = std::minmax({numbers(a.a)[k], numbers(a.b)[k], numbers(a.c)[k]});
    all = least(all, in_range(low[k], high[k], numbers(b.min)[k], numbers(b.max)[k]));
  }
  // The signs of degree 2 before those of degree 3: what is apart along one axis is apart, flat or not.
  std::array<Sign, 3> normal{};
  for (std::size_t k = 0; k < 3 && all != Sign::negative; ++k) {
    const Triangle2 flat = seen(a, k);
    normal[k] = orient2d(flat.a, flat.b, flat.c);
    all = least(all, across(flat, normal[k], seen(b, k)));
  }
  if (all == Sign::negative) return Relation::disjoint;
  if (const auto [kind, k] = flatness(b); kind != LevelKind::solid) {
    if (kind == LevelKind::straight) return relate(segment_of(b), a);
    if (low[k] == high[k]) {
      return low[k] == numbers(b.min)[k] ? query::relate(seen(a, k), seen(b, k)) : Relation::disjoint;
    }
  }
  return relation(least(all, beside(a, normal, b)));
}

}  // namespace plumb::query
