// The pairs of space: each figure as a convex set, and what two of them have in common.
#include "plumb/query/intersection.hpp"
#include "query/figure_input.hpp"
#include "query/intersection_quick.hpp"
#include "query/meet.hpp"

namespace plumb {
namespace {

template <class A, class B>
Intersection3 common(const A& a, const B& b) {
  if (auto quick = meeting::quick(a, b)) return std::move(*quick);
  query::require_figures("intersection", a, b);
  if (auto common = meeting::by_signs(a, b)) return std::move(*common);
  return meeting::meet(meeting::convex_set(a), meeting::convex_set(b));
}

}  // namespace

Intersection3 intersection(const Line3& a, const Line3& b) { return common(a, b); }
Intersection3 intersection(const Line3& a, const Ray3& b) { return common(a, b); }
Intersection3 intersection(const Line3& a, const Segment3& b) { return common(a, b); }
Intersection3 intersection(const Line3& a, const Plane3& b) { return common(a, b); }
Intersection3 intersection(const Line3& a, const ThreePointPlane3& b) { return common(a, b); }
Intersection3 intersection(const Line3& a, const Halfspace3& b) { return common(a, b); }
Intersection3 intersection(const Line3& a, const Triangle3& b) { return common(a, b); }
Intersection3 intersection(const Line3& a, const Tetrahedron3& b) { return common(a, b); }
Intersection3 intersection(const Line3& a, const Aabb3& b) { return common(a, b); }
Intersection3 intersection(const Line3& a, const Obb3& b) { return common(a, b); }
Intersection3 intersection(const Line3& a, const ConvexPolyhedron3& b) { return common(a, b); }
Intersection3 intersection(const Ray3& a, const Ray3& b) { return common(a, b); }
Intersection3 intersection(const Ray3& a, const Segment3& b) { return common(a, b); }
Intersection3 intersection(const Ray3& a, const Plane3& b) { return common(a, b); }
Intersection3 intersection(const Ray3& a, const ThreePointPlane3& b) { return common(a, b); }
Intersection3 intersection(const Ray3& a, const Halfspace3& b) { return common(a, b); }
Intersection3 intersection(const Ray3& a, const Triangle3& b) { return common(a, b); }
Intersection3 intersection(const Ray3& a, const Tetrahedron3& b) { return common(a, b); }
Intersection3 intersection(const Ray3& a, const Aabb3& b) { return common(a, b); }
Intersection3 intersection(const Ray3& a, const Obb3& b) { return common(a, b); }
Intersection3 intersection(const Ray3& a, const ConvexPolyhedron3& b) { return common(a, b); }
Intersection3 intersection(const Segment3& a, const Segment3& b) { return common(a, b); }
Intersection3 intersection(const Segment3& a, const Plane3& b) { return common(a, b); }
Intersection3 intersection(const Segment3& a, const ThreePointPlane3& b) { return common(a, b); }
Intersection3 intersection(const Segment3& a, const Halfspace3& b) { return common(a, b); }
Intersection3 intersection(const Segment3& a, const Triangle3& b) { return common(a, b); }
Intersection3 intersection(const Segment3& a, const Tetrahedron3& b) { return common(a, b); }
Intersection3 intersection(const Segment3& a, const Aabb3& b) { return common(a, b); }
Intersection3 intersection(const Segment3& a, const Obb3& b) { return common(a, b); }
Intersection3 intersection(const Segment3& a, const ConvexPolyhedron3& b) { return common(a, b); }
Intersection3 intersection(const Plane3& a, const Triangle3& b) { return common(a, b); }
Intersection3 intersection(const Plane3& a, const Tetrahedron3& b) { return common(a, b); }
Intersection3 intersection(const Plane3& a, const Aabb3& b) { return common(a, b); }
Intersection3 intersection(const Plane3& a, const Obb3& b) { return common(a, b); }
Intersection3 intersection(const Plane3& a, const ConvexPolyhedron3& b) { return common(a, b); }
Intersection3 intersection(const ThreePointPlane3& a, const Triangle3& b) { return common(a, b); }
Intersection3 intersection(const ThreePointPlane3& a, const Tetrahedron3& b) { return common(a, b); }
Intersection3 intersection(const ThreePointPlane3& a, const Aabb3& b) { return common(a, b); }
Intersection3 intersection(const ThreePointPlane3& a, const Obb3& b) { return common(a, b); }
Intersection3 intersection(const ThreePointPlane3& a, const ConvexPolyhedron3& b) { return common(a, b); }
Intersection3 intersection(const Halfspace3& a, const Triangle3& b) { return common(a, b); }
Intersection3 intersection(const Triangle3& a, const Triangle3& b) { return common(a, b); }
Intersection3 intersection(const Triangle3& a, const Tetrahedron3& b) { return common(a, b); }
Intersection3 intersection(const Triangle3& a, const Aabb3& b) { return common(a, b); }
Intersection3 intersection(const Triangle3& a, const Obb3& b) { return common(a, b); }
Intersection3 intersection(const Triangle3& a, const ConvexPolyhedron3& b) { return common(a, b); }

}  // namespace plumb
