#include "plumb/query/overlap2.hpp"

#include "overlap_parts.hpp"
#include "overlap_shapes2.hpp"

namespace plumb {
namespace {

template <class A, class B>
Relation related(const A& a, const B& b) {
  query::require_shapes(a, b);
  if constexpr (requires { query::linear(b); }) {
    return query::relate(query::linear(a), query::linear(b));
  } else if constexpr (requires { query::linear(a); }) {
    return query::relate(query::linear(a), b);
  } else {
    return query::relate(a, b);
  }
}

}  // namespace

Relation relate(const Line2& a, const Line2& b) { return related(a, b); }
Relation relate(const Line2& a, const Ray2& b) { return related(a, b); }
Relation relate(const Line2& a, const Segment2& b) { return related(a, b); }
Relation relate(const Line2& a, const Triangle2& b) { return related(a, b); }
Relation relate(const Line2& a, const Aabb2& b) { return related(a, b); }
Relation relate(const Ray2& a, const Ray2& b) { return related(a, b); }
Relation relate(const Ray2& a, const Segment2& b) { return related(a, b); }
Relation relate(const Ray2& a, const Triangle2& b) { return related(a, b); }
Relation relate(const Ray2& a, const Aabb2& b) { return related(a, b); }
Relation relate(const Segment2& a, const Segment2& b) { return related(a, b); }
Relation relate(const Segment2& a, const Triangle2& b) { return related(a, b); }
Relation relate(const Segment2& a, const Aabb2& b) { return related(a, b); }
Relation relate(const Triangle2& a, const Triangle2& b) { return related(a, b); }
Relation relate(const Triangle2& a, const Aabb2& b) { return related(a, b); }

}  // namespace plumb
