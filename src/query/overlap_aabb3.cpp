// Axis-aligned boxes in space, with what is straight and with triangles.
#include "overlap_parts.hpp"
#include "overlap_shapes3.hpp"
#include "plumb/query/overlap_box.hpp"

namespace plumb {
namespace {

template <class A>
Relation related(const A& a, const Aabb3& b) {
  query::require_shapes(a, b);
  return query::relate(query::linear(a), b);
}

}  // namespace

Relation relate(const Line3& a, const Aabb3& b) { return related(a, b); }
Relation relate(const Ray3& a, const Aabb3& b) { return related(a, b); }
Relation relate(const Segment3& a, const Aabb3& b) { return related(a, b); }

Relation relate(const Triangle3& a, const Aabb3& b) {
  query::require_shapes(a, b);
  return query::relate(a, b);
}

}  // namespace plumb
