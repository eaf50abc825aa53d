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
  require_numbers(Names<3>{"line.point", "line.direction", "p"}, line.point, line.direction, p);
  return boundary_if(on_line(line.point, line.direction, p));
}

template <class Ray, class Point>
Location locate_on_ray(const Ray& ray, const Point& p) {
  require_numbers(Names<3>{"ray.origin", "ray.direction", "p"}, ray.origin, ray.direction, p);
  return boundary_if(on_line(ray.origin, ray.direction, p) &&
                     compare_along_direction(p, ray.origin, ray.direction) != Sign::negative);
}

template <class Segment, class Point>
Location locate_on_segment(const Segment& segment, const Point& p) {
  require_numbers(Names<3>{"segment.a", "segment.b", "p"}, segment.a, segment.b, p);
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
  require_numbers(Names<3>{"halfspace.normal", "halfspace.offset", "p"}, halfspace.normal, halfspace.offset, p);
  return below(halfspace.normal, halfspace.offset, p);
}

template <class Slab, class Point>
Location locate_in_slab(const Slab& slab, const Point& p) {
  require_numbers(Names<4>{"slab.normal", "slab.min", "slab.max", "p"}, slab.normal, slab.min, slab.max, p);
  if (is_zero(slab.normal)) return slab.min <= 0 && 0 <= slab.max ? Location::inside : Location::outside;
  if (slab.min > slab.max) return Location::outside;
  return both(location(side(slab.normal, slab.max, p)), location(-side(slab.normal, slab.min, p)));
}

template <class Intersection, class Point>
Location locate_in_intersection(const Intersection& intersection, const Point& p) {
  require_numbers(Names<1>{"p"}, p);
  for (std::size_t i = 0; i < intersection.halfspaces.size(); ++i) {
    const auto& h = intersection.halfspaces[i];
    if (are_real(h.normal, h.offset)) [[likely]]
      continue;
    const std::string start = std::string("intersection.halfspaces[").append(std::to_string(i)).append("].");
    const std::string normal = start + "normal", offset = start + "offset";
    require_numbers(Names<2>{normal, offset}, h.normal, h.offset);
  }
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
  require_numbers(Names<3>{"plane.normal", "plane.offset", "p"}, plane.normal, plane.offset, p);
  if (is_zero(plane.normal)) return plane.offset == 0 ? Location::inside : Location::outside;
  return boundary_if(side_of_plane(plane.normal, plane.offset, p) == Sign::zero);
}

Location locate(const ThreePointPlane3& plane, const Point3& p) {
  const auto& [a, b, c] = plane;
  require_numbers(Names<4>{"plane.a", "plane.b", "plane.c", "p"}, a, b, c, p);
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
