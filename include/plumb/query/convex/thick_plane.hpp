// Thick planes: is a figure within so much of a plane, in front of it, behind it, or on both sides?
//
//   side_of({{0, 0, 1}, 5, 0.01}, triangle) == ThickSide::coplanar    // all of it is within 0.01 of z = 5
//
// A tolerance is the user's wish, and the decision against it is exact: no rounded distance is compared.
// Laws: (1) a point is in front where normal . x - offset > radius |normal|, behind where it is < -radius |normal|,
// else within; a figure is coplanar where all its points are within, in front where some are in front and none behind.
//  So faces whose corners are within are coplanar though their planes cross, and what touches a side of the plane is
// within. (2) Turning the normal and the offset around swaps front and behind; a factor of both changes nothing else.
// (3) A figure that is nothing is coplanar, and so is all where normal and offset are zero.
// A negative radius throws InvalidShape, NaN and infinity NonFinite.
// Source: RTCD 11.3.2, 8.3.4.
// Cost: some microseconds a corner, in rationals; milliseconds for k-DOPs and intersections of halfspaces.  Bounded by
// n signs, on integers as long as the exponents' span.
#pragma once

#include "plumb/query/body/pairs.hpp"

namespace plumb {

struct ThickPlane3 {
  Vector3 normal;  // of any length
  double offset;
  double radius;  // half of the thickness, as a distance
  friend bool operator==(const ThickPlane3&, const ThickPlane3&) = default;
};

enum class ThickSide : signed char { behind = -1, coplanar = 0, in_front = 1, straddling = 2 };

namespace query {
ThickSide side_of_view(const ThickPlane3& plane, const FigureView& figure);
}

/// All figures of space but cylinders and cones.
template <Figure Shape>
requires(figure_dimension<Shape> == 3 &&
         !query::is_one_of(figure_kind<Shape>, {FigureKind::cylinder, FigureKind::cone}))  //
    ThickSide side_of(const ThickPlane3& plane, const Shape& figure) {
  return query::side_of_view(plane, query::view_of(figure));
}

}  // namespace plumb
