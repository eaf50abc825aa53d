// The pairs of space: each figure as a convex set, and what two of them have in common.
#include "plumb/query/section/intersection.hpp"
#include "query/section/intersection_quick.hpp"

namespace plumb {

using query::meeting::intersection_of;

Intersection3 intersection(const Line3& a, const Line3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Line3& a, const Ray3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Line3& a, const Segment3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Line3& a, const Plane3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Line3& a, const ThreePointPlane3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Line3& a, const Halfspace3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Line3& a, const Triangle3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Line3& a, const Tetrahedron3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Line3& a, const Aabb3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Line3& a, const Obb3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Line3& a, const ConvexPolyhedron3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Ray3& a, const Ray3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Ray3& a, const Segment3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Ray3& a, const Plane3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Ray3& a, const ThreePointPlane3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Ray3& a, const Halfspace3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Ray3& a, const Triangle3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Ray3& a, const Tetrahedron3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Ray3& a, const Aabb3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Ray3& a, const Obb3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Ray3& a, const ConvexPolyhedron3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Segment3& a, const Segment3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Segment3& a, const Plane3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Segment3& a, const ThreePointPlane3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Segment3& a, const Halfspace3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Segment3& a, const Triangle3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Segment3& a, const Tetrahedron3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Segment3& a, const Aabb3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Segment3& a, const Obb3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Segment3& a, const ConvexPolyhedron3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Plane3& a, const Triangle3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Plane3& a, const Tetrahedron3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Plane3& a, const Aabb3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Plane3& a, const Obb3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Plane3& a, const ConvexPolyhedron3& b) { return intersection_of(a, b); }
Intersection3 intersection(const ThreePointPlane3& a, const Triangle3& b) { return intersection_of(a, b); }
Intersection3 intersection(const ThreePointPlane3& a, const Tetrahedron3& b) { return intersection_of(a, b); }
Intersection3 intersection(const ThreePointPlane3& a, const Aabb3& b) { return intersection_of(a, b); }
Intersection3 intersection(const ThreePointPlane3& a, const Obb3& b) { return intersection_of(a, b); }
Intersection3 intersection(const ThreePointPlane3& a, const ConvexPolyhedron3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Halfspace3& a, const Triangle3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Triangle3& a, const Triangle3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Triangle3& a, const Tetrahedron3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Triangle3& a, const Aabb3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Triangle3& a, const Obb3& b) { return intersection_of(a, b); }
Intersection3 intersection(const Triangle3& a, const ConvexPolyhedron3& b) { return intersection_of(a, b); }

}  // namespace plumb
