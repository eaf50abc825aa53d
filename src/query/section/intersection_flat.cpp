// The pairs of the plane: each figure as a convex set, and what two of them have in common.
#include "plumb/query/section/intersection2.hpp"
#include "query/section/intersection_quick.hpp"

namespace plumb {

using query::meeting::intersection_of;

Intersection2 intersection(const Line2& a, const Line2& b) { return intersection_of(a, b); }
Intersection2 intersection(const Line2& a, const Ray2& b) { return intersection_of(a, b); }
Intersection2 intersection(const Line2& a, const Segment2& b) { return intersection_of(a, b); }
Intersection2 intersection(const Line2& a, const Triangle2& b) { return intersection_of(a, b); }
Intersection2 intersection(const Line2& a, const Polygon2& b) { return intersection_of(a, b); }
Intersection2 intersection(const Line2& a, const Aabb2& b) { return intersection_of(a, b); }
Intersection2 intersection(const Ray2& a, const Ray2& b) { return intersection_of(a, b); }
Intersection2 intersection(const Ray2& a, const Segment2& b) { return intersection_of(a, b); }
Intersection2 intersection(const Ray2& a, const Triangle2& b) { return intersection_of(a, b); }
Intersection2 intersection(const Ray2& a, const Polygon2& b) { return intersection_of(a, b); }
Intersection2 intersection(const Ray2& a, const Aabb2& b) { return intersection_of(a, b); }
Intersection2 intersection(const Segment2& a, const Segment2& b) { return intersection_of(a, b); }
Intersection2 intersection(const Segment2& a, const Triangle2& b) { return intersection_of(a, b); }
Intersection2 intersection(const Segment2& a, const Polygon2& b) { return intersection_of(a, b); }
Intersection2 intersection(const Segment2& a, const Aabb2& b) { return intersection_of(a, b); }
Intersection2 intersection(const Triangle2& a, const Triangle2& b) { return intersection_of(a, b); }
Intersection2 intersection(const Triangle2& a, const Polygon2& b) { return intersection_of(a, b); }
Intersection2 intersection(const Triangle2& a, const Aabb2& b) { return intersection_of(a, b); }
Intersection2 intersection(const Polygon2& a, const Polygon2& b) { return intersection_of(a, b); }
Intersection2 intersection(const Polygon2& a, const Aabb2& b) { return intersection_of(a, b); }
Intersection2 intersection(const Aabb2& a, const Aabb2& b) { return intersection_of(a, b); }

}  // namespace plumb
