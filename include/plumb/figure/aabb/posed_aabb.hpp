// Bounding volume (AABB): which axis-aligned box holds a shape under a pose?
//
//   fit_aabb(Posed{capsule, RigidPose{turn, {1, 2, 3}}})
//
// Law: it is the least box of doubles that holds the exact image, each bound rounded outward once; of balls, capsules and
// lozenges too, whatever becomes of them under a matrix.
// A negative radius and the quaternion zero throw InvalidShape; NaN and infinities throw NonFinite; a bound that no
// double holds throws BeyondDoubles.
// Source: RTCD 4.2.4, 4.2.6.
// Cost: some 100 ns a bound, and a sign for each further corner; some microseconds where a root leaves a choice.
// Nothing is searched: each corner is looked at once.
#pragma once

#include <array>
#include <vector>

#include "plumb/figure/aabb/aabb.hpp"

namespace plumb {

namespace figure::box {

/// What a box must reach around: the hull of the points, from each of them the ways as far as they lead, and a ball.
struct Reach3 {
  struct Way {
    Vector3 along;
    double from, to;
  };
  std::vector<Point3> points;
  std::vector<Way> ways;
  double radius = 0;
};

/// A shape of the plane is one of space, at z = 0.
Reach3 reach_of(const Point2& shape);
Reach3 reach_of(const Point3& shape);
Reach3 reach_of(const Segment2& shape);
Reach3 reach_of(const Segment3& shape);
Reach3 reach_of(const Triangle2& shape);
Reach3 reach_of(const Triangle3& shape);
Reach3 reach_of(const Tetrahedron3& shape);
Reach3 reach_of(const Quadrilateral2& shape);
Reach3 reach_of(const Quadrilateral3& shape);
Reach3 reach_of(const Polygon2& shape);
Reach3 reach_of(const Polygon3& shape);
Reach3 reach_of(const HoledPolygon2& shape);
Reach3 reach_of(const HoledPolygon3& shape);
Reach3 reach_of(const ConvexPolyhedron3& shape);
Reach3 reach_of(const Circle2& shape);
Reach3 reach_of(const Sphere3& shape);
Reach3 reach_of(const Capsule2& shape);
Reach3 reach_of(const Capsule3& shape);
Reach3 reach_of(const Lozenge3& shape);
Reach3 reach_of(const Obb2& shape);
Reach3 reach_of(const Obb3& shape);
Reach3 reach_of(const Rectangle3& shape);

Aabb2 fit_image(const Reach3& shape, PoseView2 pose);
Aabb3 fit_image(const Reach3& shape, PoseView pose);

/// A box of axes is moved as one, so that none of its points is rounded.
template <class Shape, class By>
requires requires(const Shape& s, const By& pose) { fit_image(reach_of(s), pose); }
auto fitted_image(const Shape& s, const By& pose) { return fit_image(reach_of(s), pose); }
template <class Box, class By>
requires(std::same_as<Box, Aabb2>&& PoseOfPlane<By>) || (std::same_as<Box, Aabb3> && PoseOfSpace<By>)  //
    Box fitted_image(const Box& box, const By& pose) {
  return transform(box, pose);
}

}  // namespace figure::box

template <class Shape, class By>
requires requires(const Shape& s, const By& pose) { figure::box::fitted_image(s, pose); }
auto fit_aabb(const Posed<Shape, By>& posed) { return figure::box::fitted_image(posed.shape, posed.pose); }

}  // namespace plumb
