// Swept test, time of impact: when do figures first meet that move along lines, polytopes and polygons of all kinds,
// as they stand or under poses?
//
//   first_contact(Translating{Posed{box, pose}, {10, 0, 0}}, wall)
//   first_contact(Translating{lozenge, {0, 0, -10}}, floor_with_holes)
//
// Takes what query/time_of_impact/translating_contact.hpp takes, and Tetrahedron3, Rectangle3, Lozenge3,
// Quadrilateral3, Polygon3, HoledPolygon3, convex or not: each against each in either order, but planes against planes.
// The pose is where the figure stands; it moves by the vector as given.
// Figures of the plane under a pose of the plane, all that query/time_of_impact/flat_contact.hpp takes, move by a Vector2 in it.
// Laws: those of query/time_of_impact/translating_contact.hpp, of the exact images.  What a singular matrix flattens is
// the flat figure that it becomes; features keep the numbers that they have without the pose.  A polygon's vertices and
// edges count through its chains, an edge by the vertex that it leaves; a rectangle's are a box's of two axes, a
// lozenge's those of its parallelogram.  Where several features meet at once, those of what is no polygon count first.
// Balls, capsules and lozenges take rigid poses, and those whose columns are at right angles and of one length that is a double,
// exactly, against polygons of another length than zero; planes take those that are not singular: UnevenPose else.
// A polygon that is not planar throws InvalidShape, by name.
// Source: RTCD 3.2, 5.5, 5.5.6.
// Cost: some 50 us for two boxes; of a polygon that of a segment for each edge, and rationals for the inside.  Bounded
// by n^2 pairs of features for n corners of both, on integers as long as the exponents' span.
#pragma once

#include "plumb/query/body/posed.hpp"
#include "plumb/query/time_of_impact/translating_contact.hpp"

namespace plumb {

namespace query {

struct PosedMotion {
  PosedView figure;
  const Vector3* by;
  const Vector2* by_in_plane = nullptr;  // of a figure of the plane; none where it stands still
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

template <class A, class B>
concept PosedPairInPlane = PosedFigures<A, B> && MovesInPlane<UnposedType<A>> && MovesInPlane<UnposedType<B>>;

/// What translating_contact.hpp and flat_contact.hpp do not take.
template <class A, class B>
concept PosedMovingPair = PosedPairInPlane<A, B> ||
    (has_its_pose<A>&& has_its_pose<B>&& AnyMovingPair<UnposedType<A>, UnposedType<B>> &&
     (is_posed<A> || is_posed<B> || !MovingPair<A, B>));

inline constexpr Vector3 no_motion{0, 0, 0};
template <class Shape>
PosedMotion posed_motion(const Shape& s) {
  return {posed_view(s), &no_motion};
}
template <class Shape>
PosedMotion posed_motion(const Translating<Shape>& s) {
  if constexpr (MovesInPlane<UnposedType<Shape>>) {
    return {posed_view(s.shape), nullptr, &s.by};
  } else {
    return {posed_view(s.shape), &s.by};
  }
}

}  // namespace query

template <class A, class B>
requires query::PosedMovingPair<A, B> std::optional<Contact> first_contact(const Translating<A>& a,
                                                                           const Translating<B>& b) {
  return query::posed_contact(query::posed_motion(a), query::posed_motion(b));
}
template <class A, class B>
requires query::PosedMovingPair<A, B> std::optional<Contact> first_contact(const Translating<A>& a, const B& b) {
  return query::posed_contact(query::posed_motion(a), query::posed_motion(b));
}
template <class A, class B>
requires query::PosedMovingPair<A, B> std::optional<Contact> first_contact(const A& a, const Translating<B>& b) {
  return query::posed_contact(query::posed_motion(a), query::posed_motion(b));
}

template <class A, class B>
requires query::PosedMovingPair<A, B> std::optional<Root> first_contact_time(const Translating<A>& a,
                                                                             const Translating<B>& b) {
  return query::posed_contact_time(query::posed_motion(a), query::posed_motion(b));
}
template <class A, class B>
requires query::PosedMovingPair<A, B> std::optional<Root> first_contact_time(const Translating<A>& a, const B& b) {
  return query::posed_contact_time(query::posed_motion(a), query::posed_motion(b));
}
template <class A, class B>
requires query::PosedMovingPair<A, B> std::optional<Root> first_contact_time(const A& a, const Translating<B>& b) {
  return query::posed_contact_time(query::posed_motion(a), query::posed_motion(b));
}

template <class A, class B>
requires query::PosedMovingPair<A, B>
bool intersects(const Translating<A>& a, const Translating<B>& b) {
  return query::posed_bodies_meet(query::posed_motion(a), query::posed_motion(b));
}
template <class A, class B>
requires query::PosedMovingPair<A, B>
bool intersects(const Translating<A>& a, const B& b) {
  return query::posed_bodies_meet(query::posed_motion(a), query::posed_motion(b));
}
template <class A, class B>
requires query::PosedMovingPair<A, B>
bool intersects(const A& a, const Translating<B>& b) {
  return query::posed_bodies_meet(query::posed_motion(a), query::posed_motion(b));
}

}  // namespace plumb
