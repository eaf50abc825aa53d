// Spherical caps against balls and against flat convex sets: a cap is a ball and a halfspace, and meets what meets the
// ball within the halfspace.
#include "arith/root_sign.hpp"
#include "plumb/figure/containment/contains.hpp"
#include "query/body/figure_input.hpp"
#include "query/convex/exact_gap.hpp"
#include "query/overlap/pair_answer.hpp"

namespace plumb {
namespace query {
namespace {

Exact3 exact_of(const auto& v) { return {v.x, v.y, v.z}; }

/// The numbers of a cap, and which set it is.
struct ExactCap {
  explicit ExactCap(const SphericalCap3& cap)
      : center(exact_of(cap.sphere.center)),
        normal(exact_of(cap.halfspace.normal)),
        radius(cap.sphere.radius),
        offset(cap.halfspace.offset),
        depth(offset - dot(normal, center)),
        square(dot(normal, normal)),
        circle(radius * radius * square - depth * depth) {}

  [[nodiscard]] bool is_empty() const { return sgn(depth) < 0 && sgn(circle) < 0; }
  /// The plane's nearest point to p, for a normal that is not zero.
  [[nodiscard]] Exact3 foot(const Exact3& p) const {
    return p + mpq_class((offset - dot(normal, p)) / square) * normal;
  }
  /// The only point of a cap that has no interior and is not empty.
  [[nodiscard]] std::optional<Exact3> point() const {
    if (sgn(radius) == 0) return center;
    if (sgn(depth) < 0 && sgn(circle) == 0) return foot(center);
    return {};
  }

  Exact3 center, normal;
  mpq_class radius, offset;
  mpq_class depth, square;  // of the plane beyond the center, times the normal's length; of the normal
  mpq_class circle;         // of the circle's radius, times that of the normal
};

FlatSet single_point(const Exact3& point) { return {{point}, {}, {}, {}}; }

/// Interiors meet where that of x meets the halfspace's, and what of x the halfspace holds is nearer than the radius.
template <class Flat>
Relation relate_solid(const Flat& x, const ExactCap& exact, const SphericalCap3& cap) {
  const FlatSet set = flat_set(x);
  const Relation side = relate(set, flat_set(cap.halfspace));
  if (side == Relation::disjoint) return side;
  std::vector<ExactHalfspace> sides = halfspaces_of(set);
  sides.push_back({exact.normal, exact.offset});
  const Relation near = relate_swept(core_set(cap.sphere), cap.sphere.radius, flat_set(sides));
  return near == Relation::overlapping ? side : near;
}

template <class Flat>
Relation relate_cap(const Flat& x, const SphericalCap3& cap, Question question) {
  require_figures(question, x, cap);
  if constexpr (std::is_same_v<Flat, Point3>) {
    const Location where = locate(cap, x);
    if (where != Location::boundary) return static_cast<Relation>(where);
  }
  if (!intersects(x, cap.sphere) || !intersects(x, cap.halfspace)) return Relation::disjoint;
  const ExactCap exact(cap);
  if (exact.is_empty()) return Relation::disjoint;
  if (const auto p = exact.point()) return relate(single_point(*p), flat_set(x));
  return relate_solid(x, exact, cap);
}

/// How much farther than a radius a point outside of a cap with an interior is from it.
Sign sign_of_gap(const ExactCap& cap, const Exact3& p, const mpq_class& radius) {
  const Exact3 way = p - cap.center;
  const mpq_class square = dot(way, way), along = dot(cap.normal, way), height = along - cap.depth;
  // Is the ball's nearest point in the halfspace?  radius along <= depth |way|.
  const Sign by_root = sign_of_root(mpq_class(-cap.radius * along), cap.depth, square);
  const mpq_class both = cap.radius + radius;
  if (sgn(mpq_class(square - cap.radius * cap.radius)) > 0 && by_root != Sign::negative)
    return sign_of_rational(mpq_class(square - both * both));
  // Then what is nearest lies in the plane.  Is it the foot of p, which is beyond?
  const Exact3 from_center = cap.foot(p) - cap.center;
  if (sgn(height) > 0 && dot(from_center, from_center) <= cap.radius * cap.radius)
    return sign_of_rational(mpq_class(height * height - radius * radius * cap.square));
  // Else the circle is nearest, about the foot of the center: |p - middle|^2 + rim^2 - 2 t rim against radius^2, where t
  // is how far the feet are apart.
  const Exact3 middle = cap.foot(cap.center), to_p = p - middle, feet = cap.foot(p) - middle;
  const mpq_class rim = cap.circle / cap.square;
  return sign_of_root(mpq_class(dot(to_p, to_p) + rim - radius * radius), mpq_class(-2),
                      mpq_class(dot(feet, feet) * rim));
}

Relation relate_ball_and_cap(const Sphere3& ball, const SphericalCap3& cap, Question question) {
  require_figures(question, ball, cap);
  if (ball.radius == 0) return relate_cap(ball.center, cap, question);
  if (!intersects(ball, cap.sphere) || !intersects(ball, cap.halfspace)) return Relation::disjoint;
  const ExactCap exact(cap);
  if (exact.is_empty()) return Relation::disjoint;
  if (const auto p = exact.point()) return relate_swept(core_set(ball), ball.radius, single_point(*p));
  if (contains(cap, ball.center)) return Relation::overlapping;
  return static_cast<Relation>(-static_cast<int>(sign_of_gap(exact, exact_of(ball.center), ball.radius)));
}

}  // namespace

PLUMB_PAIR_ANSWER(Point3, SphericalCap3, relate_cap)
PLUMB_PAIR_ANSWER(Line3, SphericalCap3, relate_cap)
PLUMB_PAIR_ANSWER(Ray3, SphericalCap3, relate_cap)
PLUMB_PAIR_ANSWER(Segment3, SphericalCap3, relate_cap)
PLUMB_PAIR_ANSWER(Plane3, SphericalCap3, relate_cap)
PLUMB_PAIR_ANSWER(ThreePointPlane3, SphericalCap3, relate_cap)
PLUMB_PAIR_ANSWER(Halfspace3, SphericalCap3, relate_cap)
PLUMB_PAIR_ANSWER(Triangle3, SphericalCap3, relate_cap)
PLUMB_PAIR_ANSWER(Rectangle3, SphericalCap3, relate_cap)
PLUMB_PAIR_ANSWER(Tetrahedron3, SphericalCap3, relate_cap)
PLUMB_PAIR_ANSWER(Sphere3, SphericalCap3, relate_ball_and_cap)
PLUMB_PAIR_ANSWER(Aabb3, SphericalCap3, relate_cap)
PLUMB_PAIR_ANSWER(Obb3, SphericalCap3, relate_cap)
PLUMB_PAIR_ANSWER(KDop3, SphericalCap3, relate_cap)
PLUMB_PAIR_ANSWER(HalfspaceIntersection3, SphericalCap3, relate_cap)
PLUMB_PAIR_ANSWER(ConvexPolyhedron3, SphericalCap3, relate_cap)

}  // namespace query
}  // namespace plumb
