// Ellipsoids: do they meet another figure, one with straight edges, a ball, or an ellipsoid?
//
//   relate(Ellipsoid3{...}, triangle)         disjoint, touching or overlapping
//   relate(Ellipsoid3{...}, Posed{box, pose})
//
// Laws: those of query/overlap/overlap.hpp, of the set that figure/basic/round.hpp says: its half axes half_i axes_i are
// not rounded.  One with dependent half axes is the disk, segment or point that it is, of which figures with straight
// edges are asked, but for quadrilaterals and polygons.
// Capsules and lozenges are answered where they are as round as it: UnevenPose else, as for flat ones and balls.  NaN and
// infinity throw NonFinite, by name.  Cylinders, cones and caps are not asked.
// Source: RTCD 4.7, 5.2; src/query/convex/ellipsoid_pair.hpp.
// Cost: rationals: some 30 us.  Bounded by n signs for n corners, and of two ellipsoids by a fixed number of operations,
// on integers as long as the exponents' span: some milliseconds, and some tens where that is all of doubles.
#pragma once

#include "plumb/query/overlap/posed.hpp"

namespace plumb {

namespace query {

Relation relate_ellipsoid(std::string_view function, const Ellipsoid3& a, const PosedView& b);
Relation relate_ellipsoid(std::string_view function, const Ellipsoid3& a, const Ellipsoid3& b);

template <class Shape>
concept MeetsEllipsoid = PosedOrNot<Shape> && figure_dimension<UnposedType<Shape>>
== 3 &&
    !is_one_of(figure_kind<UnposedType<Shape>>, {FigureKind::cylinder, FigureKind::cone, FigureKind::spherical_cap});

}  // namespace query

template <query::MeetsEllipsoid Shape>
Relation relate(const Ellipsoid3& ellipsoid, const Shape& s) {
  return query::relate_ellipsoid("relate", ellipsoid, query::posed_view(s));
}
template <query::MeetsEllipsoid Shape>
Relation relate(const Shape& s, const Ellipsoid3& ellipsoid) {
  return relate(ellipsoid, s);
}
inline Relation relate(const Ellipsoid3& a, const Ellipsoid3& b) { return query::relate_ellipsoid("relate", a, b); }

template <query::MeetsEllipsoid Shape>
bool intersects(const Ellipsoid3& ellipsoid, const Shape& s) {
  return query::relate_ellipsoid("intersects", ellipsoid, query::posed_view(s)) != Relation::disjoint;
}
template <query::MeetsEllipsoid Shape>
bool intersects(const Shape& s, const Ellipsoid3& ellipsoid) {
  return intersects(ellipsoid, s);
}
inline bool intersects(const Ellipsoid3& a, const Ellipsoid3& b) {
  return query::relate_ellipsoid("intersects", a, b) != Relation::disjoint;
}

}  // namespace plumb
