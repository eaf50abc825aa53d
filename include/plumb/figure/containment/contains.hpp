// Point location, containment: where does a point lie to a shape: inside, on its boundary, or outside?  Does the shape
// contain it?
//
// A shape is the closed set that its struct's comment defines, in real arithmetic; degenerate ones are that set as
// well: an oriented box with dependent axes is a zonotope of lower dimension, a flat ellipsoid an ellipse or a segment.
// Laws: (1) the answer of real arithmetic, for all finite doubles.  (2) contains is `locate is not outside`.  (3) A set
// without interior has no inside (figure/basic/relation.hpp); a set that is all of space is all inside.  (4) Naming ends or
// corners in another order, reversing axes or half extents, permuting coordinates, and powers of two that lose no bit
// change nothing.
// A number that is NaN or infinite throws NonFinite naming it ("contains: sphere.radius is nan, not a real number"), a
// negative radius throws InvalidShape.
// Source: RTCD 3.4, 3.5, 3.6, 4.2, 4.3, 4.4, 4.5, 4.6, 4.7.
// Cost: comparisons for axis-aligned boxes, inline; a call and the filters of one to six formulas for the others, the
// exact stages (docs/proof.md) where a point is on the boundary or all but so.  Nothing is searched.
#pragma once

#include <concepts>

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/plane.hpp"
#include "plumb/figure/basic/relation.hpp"
#include "plumb/figure/basic/round.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb {

Location locate(const Line2& line, const Point2& p);
Location locate(const Line3& line, const Point3& p);
Location locate(const Ray2& ray, const Point2& p);
Location locate(const Ray3& ray, const Point3& p);
Location locate(const Segment2& segment, const Point2& p);
Location locate(const Segment3& segment, const Point3& p);

Location locate(const Plane3& plane, const Point3& p);
Location locate(const ThreePointPlane3& plane, const Point3& p);
Location locate(const Halfspace2& halfspace, const Point2& p);
Location locate(const Halfspace3& halfspace, const Point3& p);
Location locate(const Slab2& slab, const Point2& p);
Location locate(const Slab3& slab, const Point3& p);
Location locate(const HalfspaceIntersection2& intersection, const Point2& p);
Location locate(const HalfspaceIntersection3& intersection, const Point3& p);

Location locate(const Triangle2& triangle, const Point2& p);
Location locate(const Triangle3& triangle, const Point3& p);
Location locate(const Tetrahedron3& tetrahedron, const Point3& p);

Location locate(const Circle2& circle, const Point2& p);
Location locate(const Sphere3& sphere, const Point3& p);
Location locate(const Capsule2& capsule, const Point2& p);
Location locate(const Capsule3& capsule, const Point3& p);
Location locate(const Lozenge3& lozenge, const Point3& p);
Location locate(const Cylinder3& cylinder, const Point3& p);
Location locate(const Cone3& cone, const Point3& p);
Location locate(const Ellipsoid3& ellipsoid, const Point3& p);
Location locate(const SphericalCap3& cap, const Point3& p);

Location locate(const Aabb2& box, const Point2& p);
Location locate(const Aabb3& box, const Point3& p);
Location locate(const AabbWidths3& box, const Point3& p);
Location locate(const AabbCenter3& box, const Point3& p);
Location locate(const Obb2& box, const Point2& p);
Location locate(const Obb3& box, const Point3& p);
Location locate(const Rectangle3& rectangle, const Point3& p);

/// What can be asked for the place of a point.
template <class Shape, class Point>
concept LocatesPoints = requires(const Shape& shape, const Point& p) {
  { locate(shape, p) } -> std::same_as<Location>;
};

template <class Shape>
requires LocatesPoints<Shape, Point2>
bool contains(const Shape& shape, const Point2& p) { return locate(shape, p) != Location::outside; }
template <class Shape>
requires LocatesPoints<Shape, Point3>
bool contains(const Shape& shape, const Point3& p) { return locate(shape, p) != Location::outside; }

/// The point as numbers in braces.  An overload of its own: elsewhere contains asks of two shapes, and there {1, 2, 3}
/// could as well be the start of a box.
template <class Shape>
requires LocatesPoints<Shape, Point2>
bool contains(const Shape& shape, const double (&p)[2]) {
  return locate(shape, Point2{p[0], p[1]}) != Location::outside;
}
template <class Shape>
requires LocatesPoints<Shape, Point3>
bool contains(const Shape& shape, const double (&p)[3]) {
  return locate(shape, Point3{p[0], p[1], p[2]}) != Location::outside;
}

namespace figure::containment {

[[noreturn]] void throw_non_finite(const Aabb2& box, const Point2& p);
[[noreturn]] void throw_non_finite(const Aabb3& box, const Point3& p);

// Zero for a real number, NaN otherwise.
constexpr double not_real(const Point2& p) { return (p.x - p.x) + (p.y - p.y); }
constexpr double not_real(const Point3& p) { return (p.x - p.x) + (p.y - p.y) + (p.z - p.z); }

}  // namespace figure::containment

inline Location locate(const Aabb2& box, const Point2& p) {
  const auto& [a, b] = box;
  if (!(figure::containment::not_real(a) + figure::containment::not_real(b) + figure::containment::not_real(p) == 0))
      [[unlikely]]
    figure::containment::throw_non_finite(box, p);
  const bool closed = (a.x <= p.x) & (p.x <= b.x) & (a.y <= p.y) & (p.y <= b.y);
  const bool open = (a.x < p.x) & (p.x < b.x) & (a.y < p.y) & (p.y < b.y);
  return static_cast<Location>(static_cast<int>(closed) + static_cast<int>(open) - 1);
}

inline Location locate(const Aabb3& box, const Point3& p) {
  const auto& [a, b] = box;
  if (!(figure::containment::not_real(a) + figure::containment::not_real(b) + figure::containment::not_real(p) == 0))
      [[unlikely]]
    figure::containment::throw_non_finite(box, p);
  const bool closed = (a.x <= p.x) & (p.x <= b.x) & (a.y <= p.y) & (p.y <= b.y) & (a.z <= p.z) & (p.z <= b.z);
  const bool open = (a.x < p.x) & (p.x < b.x) & (a.y < p.y) & (p.y < b.y) & (a.z < p.z) & (p.z < b.z);
  return static_cast<Location>(static_cast<int>(closed) + static_cast<int>(open) - 1);
}

}  // namespace plumb
