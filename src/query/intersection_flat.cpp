// The pairs of the plane: each figure as a convex set, and what two of them have in common.
#include "plumb/query/intersection2.hpp"
#include "query/figure_input.hpp"
#include "query/intersection_quick.hpp"
#include "query/meet.hpp"

namespace plumb {
namespace {

template <class A, class B>
Intersection2 common(const A& a, const B& b) {
  if (auto quick = meeting::quick(a, b)) return std::move(*quick);
  query::require_figures("intersection", a, b);
  if (auto common = meeting::by_signs(a, b)) return std::move(*common);
  return meeting::meet(meeting::convex_set(a), meeting::convex_set(b));
}

}  // namespace

Intersection2 intersection(const Line2& a, const Line2& b) { return common(a, b); }
Intersection2 intersection(const Line2& a, const Ray2& b) { return common(a, b); }
Intersection2 intersection(const Line2& a, const Segment2& b) { return common(a, b); }
Intersection2 intersection(const Line2& a, const Triangle2& b) { return common(a, b); }
Intersection2 intersection(const Line2& a, const Polygon2& b) { return common(a, b); }
Intersection2 intersection(const Line2& a, const Aabb2& b) { return common(a, b); }
Intersection2 intersection(const Ray2& a, const Ray2& b) { return common(a, b); }
Intersection2 intersection(const Ray2& a, const Segment2& b) { return common(a, b); }
Intersection2 intersection(const Ray2& a, const Triangle2& b) { return common(a, b); }
Intersection2 intersection(const Ray2& a, const Polygon2& b) { return common(a, b); }
Intersection2 intersection(const Ray2& a, const Aabb2& b) { return common(a, b); }
Intersection2 intersection(const Segment2& a, const Segment2& b) { return common(a, b); }
Intersection2 intersection(const Segment2& a, const Triangle2& b) { return common(a, b); }
Intersection2 intersection(const Segment2& a, const Polygon2& b) { return common(a, b); }
Intersection2 intersection(const Segment2& a, const Aabb2& b) { return common(a, b); }
Intersection2 intersection(const Triangle2& a, const Triangle2& b) { return common(a, b); }
Intersection2 intersection(const Triangle2& a, const Polygon2& b) { return common(a, b); }
Intersection2 intersection(const Triangle2& a, const Aabb2& b) { return common(a, b); }
Intersection2 intersection(const Polygon2& a, const Polygon2& b) { return common(a, b); }
Intersection2 intersection(const Polygon2& a, const Aabb2& b) { return common(a, b); }
Intersection2 intersection(const Aabb2& a, const Aabb2& b) { return common(a, b); }

}  // namespace plumb
