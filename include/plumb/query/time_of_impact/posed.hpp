// Swept test, time of impact: when do figures first meet that move along lines, polytopes and polygons of all kinds,
// as they stand or under poses?
//
//   first_contact(Translating{Posed{box, pose}, {10, 0, 0}}, wall)
//   first_contact(Translating{lozenge, {0, 0, -10}}, floor_with_holes)
//   first_contact(Translating{Circle2{{0, 0}, 1}, {10, 0}}, floor_plan)
//
// Takes what query/time_of_impact/translating_contact.hpp takes, and Tetrahedron3, Rectangle3, Lozenge3,
// Quadrilateral3, Polygon3, HoledPolygon3, convex or not: each against each in either order, but planes against planes.
// The pose is where the figure stands; it moves by the vector as given.
// In the plane it takes Point2, Segment2, Triangle2, Aabb2, Obb2, Circle2, Capsule2, Polygon2 and HoledPolygon2 in any
// pair, as they stand or under poses of the plane; they move by a Vector2.
// Laws: those of query/time_of_impact/translating_contact.hpp, of the exact images.  What a singular matrix flattens is
// the flat figure that it becomes; features keep the numbers that they have without the pose.  A polygon's vertices and
// edges count through its chains, an edge by the vertex that it leaves; a rectangle's are a box's of two axes, a
// lozenge's those of its parallelogram; in the plane they are those of query/ray/ray2.hpp, a circle as a whole is
// {edge, 0}, a capsule's ends are vertices and the rest edge 0.
// Balls, capsules and lozenges take rigid poses, and those whose columns are at right angles and of one length that is a double,
// exactly, against polygons of another length than zero; planes take those that are not singular: UnevenPose else.
// A polygon that is not planar throws InvalidShape, by name.
// Source: RTCD 3.2, 5.5, and 5.5.3 to 5.5.8 in the plane.
// Cost: some 50 us for two boxes under poses; in the plane that of translating_contact.hpp where neither is posed; of a polygon that of a segment for each edge, and rationals for the inside.  Bounded
// by n^2 pairs of features for n corners of both, on integers as long as the exponents' span.
#pragma once

#include "plumb/figure/basic/polygon.hpp"
#include "plumb/query/body/posed.hpp"
#include "plumb/query/time_of_impact/translating_contact.hpp"

namespace plumb {

namespace query {

/// During time [0, 1]; of a figure of the plane by.z is zero.
struct PosedMotion {
  PosedView figure;
  Vector3 by;
  double radius = 0;  // within which of a convex figure of space all is meant, under a rigid pose
};
std::optional<Contact> posed_contact(const PosedMotion& a, const PosedMotion& b);
std::optional<Root> posed_contact_time(const PosedMotion& a, const PosedMotion& b);
bool posed_bodies_meet(const PosedMotion& a, const PosedMotion& b);

template <class Shape>
concept MovesInSpace = Figure<Shape> && figure_dimension<Shape>
== 3 && (MovesStraight<Shape> ||
         is_one_of(figure_kind<Shape>, {FigureKind::quadrilateral, FigureKind::polygon, FigureKind::holed_polygon,
                                        FigureKind::rectangle, FigureKind::tetrahedron, FigureKind::lozenge}));
template <class A, class B>
concept AnyMovingPair = MovesInSpace<A> && MovesInSpace<B> && !(std::same_as<A, Plane3> && std::same_as<B, Plane3>);

/// What translating_contact.hpp does not take.
template <class A, class B>
concept PosedMovingPair = has_its_pose<A> && has_its_pose<B> &&
    ((MovesInPlane<UnposedType<A>> && MovesInPlane<UnposedType<B>>) ||
     (AnyMovingPair<UnposedType<A>, UnposedType<B>> && (is_posed<A> || is_posed<B> || !MovingPair<A, B>)));

template <class Shape>
PosedMotion posed_motion(const Translating<Shape>& s) {
  if constexpr (requires { s.by.z; }) {
    return {posed_view(s.shape), s.by};
  } else {
    return {posed_view(s.shape), {s.by.x, s.by.y, 0}};
  }
}

}  // namespace query

template <class A, class B>
requires query::PosedMovingPair<A, B> std::optional<Contact> first_contact(const Translating<A>& a,
                                                                           const Translating<B>& b) {
  return query::posed_contact(query::posed_motion(a), query::posed_motion(b));
}
template <class A, class B>
requires query::PosedMovingPair<A, B> std::optional<Root> first_contact_time(const Translating<A>& a,
                                                                             const Translating<B>& b) {
  return query::posed_contact_time(query::posed_motion(a), query::posed_motion(b));
}
template <class A, class B>
requires query::PosedMovingPair<A, B>
bool intersects(const Translating<A>& a, const Translating<B>& b) {
  return query::posed_bodies_meet(query::posed_motion(a), query::posed_motion(b));
}

}  // namespace plumb
