// What is straight in space: among itself, and with triangles.
#include "overlap_filters.hpp"
#include "overlap_parts.hpp"
#include "plumb/query/overlap_triangle.hpp"

namespace plumb {
namespace query {
namespace {

std::optional<Relation> quick(const Segment3& s, const Triangle3& t) {
  return by_doubles(Reach::segment, s.a, difference(s.a, s.b), t);
}
std::optional<Relation> quick(const Ray3& r, const Triangle3& t) {
  return by_doubles(Reach::ray, r.origin, {r.direction.x, r.direction.y, r.direction.z}, t);
}
std::optional<Relation> quick(const Line3& l, const Triangle3& t) {
  return by_doubles(Reach::line, l.point, {l.direction.x, l.direction.y, l.direction.z}, t);
}

}  // namespace
}  // namespace query

namespace {

template <class A, class B>
Relation related(const A& a, const B& b) {
  if constexpr (std::is_same_v<B, Triangle3>) {
    assert_sound_thread();
    if (const auto answer = query::quick(a, b)) return *answer;
    query::require_shapes(a, b);
    return query::relate(query::linear(a), b);
  } else {
    query::require_shapes(a, b);
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
