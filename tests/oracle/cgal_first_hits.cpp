#include <CGAL/intersections.h>
#include <CGAL/squared_distance_3.h>

#include "oracle/cgal_figures.hpp"
#include "oracle/first_hits.hpp"

namespace plumb::oracle {
namespace {

/// Nothing for a ray that is a point.
template <class Ask>
std::optional<bool> with(const AnyRay& ray, const Ask& ask) {
  if (ray.kind == AnyRay::Kind::segment) {
    if (ray.origin == ray.end) return {};
    return ask(Kernel::Segment_3(of(ray.origin), of(ray.end)));
  }
  if (ray.direction == Vector3{0, 0, 0}) return {};
  if (ray.kind == AnyRay::Kind::ray) return ask(Kernel::Ray_3(of(ray.origin), of(ray.direction)));
  return ask(Kernel::Line_3(of(ray.origin), of(ray.direction)));
}
template <class Shape>
std::optional<bool> meets(const AnyRay& ray, const Shape& shape) {
  if (shape.is_degenerate()) return {};
  return with(ray, [&](const auto& straight) { return CGAL::do_intersect(straight, shape); });
}

}  // namespace

std::optional<bool> is_hit(const AnyRay& ray, const Triangle3& t) { return meets(ray, of(t)); }
std::optional<bool> is_hit(const AnyRay& ray, const Tetrahedron3& t) { return meets(ray, of(t)); }
std::optional<bool> is_hit(const AnyRay& ray, const Aabb3& b) {
  if (!(b.min.x < b.max.x && b.min.y < b.max.y && b.min.z < b.max.z)) return {};
  // CGAL 5.5 holds a line within the plane x = min.x or max.x for one that meets the box, wherever else it runs.
  const bool in_face = ray.direction.x == 0 && (ray.origin.x == b.min.x || ray.origin.x == b.max.x);
  if (ray.kind == AnyRay::Kind::line && in_face) return {};
  return meets(ray, of(b));
}
std::optional<bool> is_hit(const AnyRay& ray, const Sphere3& s) {
  return with(ray, [&](const auto& straight) {
    return CGAL::squared_distance(of(s.center), straight) <= Number(s.radius) * Number(s.radius);
  });
}
std::optional<bool> is_hit(const AnyRay& ray, const Plane3& p) { return meets(ray, of(p)); }

}  // namespace plumb::oracle
