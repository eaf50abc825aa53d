#include "query/convex/cap_relation.hpp"

#include "arith/root_sign.hpp"
#include "query/convex/core.hpp"
#include "query/convex/exact_gap.hpp"
#include "query/convex/posed_set.hpp"

namespace plumb::query {
namespace {

Exact3 numbers_of_cap(const auto& v) { return {v.x, v.y, v.z}; }

FlatSet single_point(const Exact3& point) { return {{point}, {}, {}, {}}; }

/// The numbers of a cap, and which set it is.
struct ExactCap {
  explicit ExactCap(const SphericalCap3& cap)
      : center(numbers_of_cap(cap.sphere.center)),
        normal(numbers_of_cap(cap.halfspace.normal)),
        radius(cap.sphere.radius),
        offset(cap.halfspace.offset),
        depth(offset - dot(normal, center)),
        square(dot(normal, normal)),
        circle(radius * radius * square - depth * depth) {}

  /// The plane's nearest point to p, for a normal that is not zero.
  [[nodiscard]] Exact3 foot(const Exact3& p) const {
    return p + mpq_class((offset - dot(normal, p)) / square) * normal;
  }
  [[nodiscard]] std::optional<FlatSet> thin() const {
    if (sgn(depth) < 0 && sgn(circle) < 0) return FlatSet{};
    if (sgn(radius) == 0) return single_point(center);
    if (sgn(depth) < 0 && sgn(circle) == 0) return single_point(foot(center));
    return {};
  }

  Exact3 center, normal;
  mpq_class radius, offset;
  mpq_class depth, square;  // of the plane beyond the center, times the normal's length; of the normal
  mpq_class circle;         // of the circle's radius, times that of the normal
};

/// Interiors meet where that of the set meets the halfspace's, and what of the set the halfspace holds is nearer than the
/// radius.
Relation relate_solid(const FlatSet& set, const ExactCap& exact, const SphericalCap3& cap) {
  const Relation side = relate(set, flat_set(cap.halfspace));
  if (side == Relation::disjoint) return side;
  std::vector<ExactHalfspace> sides = halfspaces_of(set);
  sides.push_back({exact.normal, exact.offset});
  const Relation near = relate_swept(core_of(cap.sphere), cap.sphere.radius, flat_set(sides));
  return near == Relation::overlapping ? side : near;
}

/// How much farther than a radius, of which this is the square, a point outside of a cap with an interior is from it.
Sign sign_of_cap_gap(const ExactCap& cap, const Exact3& p, const mpq_class& reach) {
  const Exact3 way = p - cap.center;
  const mpq_class square = dot(way, way), along = dot(cap.normal, way), height = along - cap.depth;
  // Is the ball's nearest point in the halfspace?  radius along <= depth |way|.
  const Sign by_root = sign_of_root(mpq_class(-cap.radius * along), cap.depth, square);
  const mpq_class own = cap.radius * cap.radius;
  if (square > own && by_root != Sign::negative) return static_cast<Sign>(-sign_of_roots(own, reach, square));
  // Then what is nearest lies in the plane.  Is it the foot of p, which is beyond?
  const Exact3 from_center = cap.foot(p) - cap.center;
  if (sgn(height) > 0 && dot(from_center, from_center) <= cap.radius * cap.radius)
    return sign_of_rational(mpq_class(height * height - reach * cap.square));
  // Else the circle is nearest, about the foot of the center: |p - middle|^2 + rim^2 - 2 t rim against reach, where t
  // is how far the feet are apart.
  const Exact3 middle = cap.foot(cap.center), to_p = p - middle, feet = cap.foot(p) - middle;
  const mpq_class rim = cap.circle / cap.square;
  return sign_of_root(mpq_class(dot(to_p, to_p) + rim - reach), mpq_class(-2), mpq_class(dot(feet, feet) * rim));
}

}  // namespace

std::optional<FlatSet> thin_cap(const SphericalCap3& cap) { return ExactCap(cap).thin(); }

Relation relate_exact_cap(const FlatSet& set, const SphericalCap3& cap) {
  const ExactCap exact(cap);
  if (const auto thin = exact.thin()) return thin->points.empty() ? Relation::disjoint : relate(*thin, set);
  return relate_solid(set, exact, cap);
}

Relation relate_exact_cap(const Exact3& center, const mpq_class& squared_radius, const SphericalCap3& cap) {
  const ExactCap exact(cap);
  if (const auto thin = exact.thin()) {
    if (thin->points.empty()) return Relation::disjoint;
    const Exact3 way = thin->points[0] - center;
    return static_cast<Relation>(sgn(mpq_class(squared_radius - dot(way, way))));
  }
  const Exact3 way = center - exact.center;
  if (dot(way, way) <= exact.radius * exact.radius && dot(exact.normal, way) <= exact.depth)
    return Relation::overlapping;
  return static_cast<Relation>(-static_cast<int>(sign_of_cap_gap(exact, center, squared_radius)));
}

}  // namespace plumb::query
