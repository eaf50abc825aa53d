// Support mapping under a pose: how far does a figure reach along a direction, and which box holds it?
//
//   support_value(Posed{cylinder, RigidPose{turn, {1, 2, 3}}}, {0, 0, 1})
//   fit_aabb(Posed{cone, pose})
//
// Takes what support_value takes without a pose, under every pose.  Boxes of figures with corners and of balls, capsules
// and lozenges are those of figure/aabb/posed_aabb.hpp; these are of cylinders, cones, caps and k-DOPs.
// Laws: (1) the value is the exact one of the exact image, rounded once as asked: a root of the pose's numbers, for
// matrices that are no similarities as well.  (2) It is that of the figure along the direction that the matrix's
// transpose makes of the given one, and as much more as the translation leads along it.  (3) A box has the least bounds that
// hold the image; of an empty k-DOP it is empty.
// NaN and infinity throw NonFinite, a negative radius and what is empty or unbounded InvalidShape, by name; a bound that
// no double holds throws BeyondDoubles.
// Source: RTCD 3.8, 4.2.6.
// Cost: some 50 us, in rationals; that of flat_set for k-DOPs.  Bounded by n sums for n corners, of integers as long
// as the exponents' span.
#pragma once

#include "plumb/figure/aabb/posed_aabb.hpp"
#include "plumb/figure/k_dop/k_dop.hpp"
#include "plumb/figure/support/support.hpp"
#include "plumb/query/body/posed.hpp"

namespace plumb {

namespace query {

/// The direction of what lies in the plane has z = 0.
double posed_support_value(const PosedView& figure, const Vector3& direction, Rounding rounding);
Aabb3 posed_box(const PosedView& figure);

template <class Shape, class Vector>
concept ReachesAlong = Figure<Shape> && requires(const Shape& s, const Vector& v) {
  { support_value(s, v, Rounding::up) } -> std::same_as<double>;
};
template <class Shape, class By>
concept BoxedByReach = PosedOrNot<Posed<Shape, By>> &&
    is_one_of(figure_kind<Shape>,
              {FigureKind::cylinder, FigureKind::cone, FigureKind::spherical_cap, FigureKind::k_dop});

}  // namespace query

template <class Shape, class By>
requires(PosedOrNot<Posed<Shape, By>>&& query::ReachesAlong<Shape, Vector2>)  //
    double support_value(const Posed<Shape, By>& posed, const Vector2& direction, Rounding rounding = Rounding::up) {
  return query::posed_support_value(query::posed_view(posed), {direction.x, direction.y, 0}, rounding);
}
template <class Shape, class By>
requires(PosedOrNot<Posed<Shape, By>>&& query::ReachesAlong<Shape, Vector3>)  //
    double support_value(const Posed<Shape, By>& posed, const Vector3& direction, Rounding rounding = Rounding::up) {
  return query::posed_support_value(query::posed_view(posed), direction, rounding);
}

template <class Shape, class By>
requires query::BoxedByReach<Shape, By>
auto fit_aabb(const Posed<Shape, By>& posed) {
  const Aabb3 box = query::posed_box(query::posed_view(posed));
  if constexpr (figure_dimension<Shape> == 3) {
    return box;
  } else {
    return Aabb2{{box.min.x, box.min.y}, {box.max.x, box.max.y}};
  }
}

}  // namespace plumb
