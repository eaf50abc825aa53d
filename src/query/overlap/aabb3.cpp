// Axis-aligned boxes in space, with what is straight and with triangles.
#include "query/body/figure_input.hpp"
#include "query/overlap/box_quick.hpp"
#include "query/overlap/pair_answer.hpp"
#include "query/overlap/shapes3.hpp"

namespace plumb {
namespace {

template <class A>
Relation exact_relation(const A& a, const Aabb3& b) {
  return query::relate(query::linear(a), b);
}
/// One of equal vertices is a segment.
Relation exact_relation(const Triangle3& a, const Aabb3& b) {
  if (a.a == a.b || a.c == a.a) return query::relate(query::linear(Segment3{a.b, a.c}), b);
  if (a.b == a.c) return query::relate(query::linear(Segment3{a.a, a.b}), b);
  return query::relate(a, b);
}

// The vertices against the box, by comparing what is given.
bool is_strictly_inside(const Point3& p, const Aabb3& box) {
  return box.min.x < p.x && p.x < box.max.x && box.min.y < p.y && p.y < box.max.y && box.min.z < p.z && p.z < box.max.z;
}
bool is_inside(const Point3& p, const Aabb3& box) {
  return box.min.x <= p.x && p.x <= box.max.x && box.min.y <= p.y && p.y <= box.max.y && box.min.z <= p.z &&
         p.z <= box.max.z;
}
bool any_vertex(const Line3&, const auto&) { return false; }
bool any_vertex(const Ray3& r, const auto& is_so) { return is_so(r.origin); }
bool any_vertex(const Segment3& s, const auto& is_so) { return is_so(s.a) || is_so(s.b); }
bool any_vertex(const Triangle3& t, const auto& is_so) { return is_so(t.a) || is_so(t.b) || is_so(t.c); }

/// Where it is asked whether they meet, any relation but disjoint is an answer.
template <class A>
[[gnu::noinline]] Relation exactly(const A& a, const Aabb3& b, query::Question question) {
  query::require_figures(question, a, b);
  if (is_empty(b)) return Relation::disjoint;
  // What lies next to a vertex is inside as well.
  if (any_vertex(a, [&b](const Point3& p) { return is_strictly_inside(p, b); })) return Relation::overlapping;
  if (question != query::Question::relate && any_vertex(a, [&b](const Point3& p) { return is_inside(p, b); }))
    return Relation::touching;
  return exact_relation(a, b);
}

template <class A>
Relation relate_to_aabb(const A& a, const Aabb3& b, query::Question question) {
  assert_sound_thread();
  const auto answer = query::quick_relation(a, b);
  return answer ? *answer : exactly(a, b, question);
}

}  // namespace

namespace query {

PLUMB_PAIR_ANSWERS_TO(Aabb3, relate_to_aabb, Line3, Ray3, Segment3, Triangle3)

}  // namespace query

}  // namespace plumb
