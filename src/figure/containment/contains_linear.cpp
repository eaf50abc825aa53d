// Lines, rays, segments, and what has a normal.
#include "figure/containment/contains_input.hpp"
#include "plumb/certify/direction.hpp"
#include "plumb/certify/side_of_plane.hpp"

namespace plumb {
namespace figure::containment {

// The cross product of the direction and the way to p is the order of the two points along the direction turned left.
bool on_line(const Point2& point, const Vector2& direction, const Point2& p) {
  if (is_zero(direction)) return point == p;
  return compare_along_direction(p, point, Vector2{-direction.y, direction.x}) == Sign::zero;
}
bool on_line(const Point3& point, const Vector3& direction, const Point3& p) {
  if (is_zero(direction)) return point == p;
  const auto parallel_in = [](double a, double b, double u, double v, double x, double y) {
    return compare_along_direction(Point2{x, y}, Point2{a, b}, Vector2{-v, u}) == Sign::zero;
  };
  return parallel_in(point.x, point.y, direction.x, direction.y, p.x, p.y) &&
         parallel_in(point.y, point.z, direction.y, direction.z, p.y, p.z) &&
         parallel_in(point.z, point.x, direction.z, direction.x, p.z, p.x);
}

namespace {

template <class Line, class Point>
Location locate_on_line(const Line& line, const Point& p) {
  figure::require_sound("contains", line, part::place("p", p));
  return boundary_if(on_line(line.point, line.direction, p));
}

template <class Ray, class Point>
Location locate_on_ray(const Ray& ray, const Point& p) {
  figure::require_sound("contains", ray, part::place("p", p));
  return boundary_if(on_line(ray.origin, ray.direction, p) &&
                     compare_along_direction(p, ray.origin, ray.direction) != Sign::negative);
}

template <class Segment, class Point>
Location locate_on_segment(const Segment& segment, const Point& p) {
  figure::require_sound("contains", segment, part::place("p", p));
  return boundary_if(are_ordered_along_line(segment.a, p, segment.b));
}

Sign side(const Vector2& normal, double offset, const Point2& p) { return side_of_line(normal, offset, p); }
Sign side(const Vector3& normal, double offset, const Point3& p) { return side_of_plane(normal, offset, p); }

/// Of normal . x <= offset: all of space or nothing where the normal is zero.
template <class Vector, class Point>
Location below(const Vector& normal, double offset, const Point& p) {
  if (is_zero(normal)) return offset < 0 ? Location::outside : Location::inside;
  return location(side(normal, offset, p));
}

template <class Halfspace, class Point>
Location locate_in_halfspace(const Halfspace& halfspace, const Point& p) {
  figure::require_sound("contains", halfspace, part::place("p", p));
  return below(halfspace.normal, halfspace.offset, p);
}

template <class Slab, class Point>
Location locate_in_slab(const Slab& slab, const Point& p) {
  figure::require_sound("contains", slab, part::place("p", p));
  if (is_zero(slab.normal)) return slab.min <= 0 && 0 <= slab.max ? Location::inside : Location::outside;
  if (slab.min > slab.max) return Location::outside;
  return both(location(side(slab.normal, slab.max, p)), location(-side(slab.normal, slab.min, p)));
}

template <class Intersection, class Point>
Location locate_in_intersection(const Intersection& intersection, const Point& p) {
  figure::require_sound("contains", intersection, part::place("p", p));
  Location all = Location::inside;
  for (const auto& h : intersection.halfspaces) {
    all = both(all, below(h.normal, h.offset, p));
    if (all == Location::outside) break;
  }
  return all;
}

}  // namespace
}  // namespace figure::containment

using namespace figure::containment;

Location locate(const Line2& line, const Point2& p) { return locate_on_line(line, p); }
Location locate(const Line3& line, const Point3& p) { return locate_on_line(line, p); }
Location locate(const Ray2& ray, const Point2& p) { return locate_on_ray(ray, p); }
Location locate(const Ray3& ray, const Point3& p) { return locate_on_ray(ray, p); }
Location locate(const Segment2& segment, const Point2& p) { return locate_on_segment(segment, p); }
Location locate(const Segment3& segment, const Point3& p) { return locate_on_segment(segment, p); }

Location locate(const Plane3& plane, const Point3& p) {
  figure::require_sound("contains", plane, part::place("p", p));
  if (is_zero(plane.normal)) return plane.offset == 0 ? Location::inside : Location::outside;
  return boundary_if(side_of_plane(plane.normal, plane.offset, p) == Sign::zero);
}

Location locate(const ThreePointPlane3& plane, const Point3& p) {
  const auto& [a, b, c] = plane;
  figure::require_sound("contains", plane, part::place("p", p));
  if (sign_of(predicates::Orient3d{}, a, b, c, p) != Sign::zero) return Location::outside;
  if (!collinear(a, b, c)) return Location::boundary;
  const Point3& other = a == b ? c : b;
  return boundary_if(a == other ? p == a : collinear(a, other, p));
}

Location locate(const Halfspace2& halfspace, const Point2& p) { return locate_in_halfspace(halfspace, p); }
Location locate(const Halfspace3& halfspace, const Point3& p) { return locate_in_halfspace(halfspace, p); }
Location locate(const Slab2& slab, const Point2& p) { return locate_in_slab(slab, p); }
Location locate(const Slab3& slab, const Point3& p) { return locate_in_slab(slab, p); }
Location locate(const HalfspaceIntersection2& intersection, const Point2& p) {
  return locate_in_intersection(intersection, p);
}
Location locate(const HalfspaceIntersection3& intersection, const Point3& p) {
  return locate_in_intersection(intersection, p);
}

}  // namespace plumb
