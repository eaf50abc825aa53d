// What is straight in space: among itself, and with triangles.
#include "overlap_linear3.hpp"
#include "overlap_parts.hpp"
#include "plumb/query/overlap_triangle.hpp"

namespace plumb {
namespace {

template <class A, class B>
Relation related(const A& a, const B& b) {
  query::require_shapes(a, b);
  if constexpr (std::is_same_v<B, Triangle3>) {
    return query::relate(query::linear(a), b);
  } else {
    return query::relate(query::linear(a), query::linear(b));
  }
}

}  // namespace

Relation relate(const Line3& a, const Triangle3& b) { return related(a, b); }
Relation relate(const Ray3& a, const Triangle3& b) { return related(a, b); }
Relation relate(const Segment3& a, const Triangle3& b) { return related(a, b); }

Relation relate(const Line3& a, const Line3& b) { return related(a, b); }
Relation relate(const Line3& a, const Ray3& b) { return related(a, b); }
Relation relate(const Line3& a, const Segment3& b) { return related(a, b); }
Relation relate(const Ray3& a, const Ray3& b) { return related(a, b); }
Relation relate(const Ray3& a, const Segment3& b) { return related(a, b); }
Relation relate(const Segment3& a, const Segment3& b) { return related(a, b); }

}  // namespace plumb
