// Axis-aligned boxes in space, with what is straight and with triangles.
#include "figure_input.hpp"
#include "overlap_box_filter.hpp"
#include "overlap_shapes3.hpp"
#include "overlap_signs.hpp"
#include "plumb/query/overlap_box.hpp"

namespace plumb {
namespace {

template <class A>
[[gnu::noinline]] Relation exactly(const A& a, const Aabb3& b, Asked asked) {
  query::require_figures(asked, a, b);
  return query::relate(query::linear(a), b);
}
[[gnu::noinline]] Relation exactly(const Triangle3& a, const Aabb3& b, Asked asked) {
  query::require_figures(asked, a, b);
  if (query::is_empty(b)) return Relation::disjoint;
  if (const auto answer = query::by_doubles<true>(a, b)) return *answer;
  return query::relate(a, b);
}

}  // namespace

// An empty box is one of negative extent to the filters.
Relation relate(const Line3& a, const Aabb3& b, Asked asked) {
  assert_sound_thread();
  const auto answer = query::by_doubles(query::Reach::line, a.point, a.direction, b);
  return answer && !query::is_empty(b) ? *answer : exactly(a, b, asked);
}
Relation relate(const Ray3& a, const Aabb3& b, Asked asked) {
  assert_sound_thread();
  const auto answer = query::by_doubles(query::Reach::ray, a.origin, a.direction, b);
  return answer && !query::is_empty(b) ? *answer : exactly(a, b, asked);
}
Relation relate(const Segment3& a, const Aabb3& b, Asked asked) {
  assert_sound_thread();
  const auto answer = query::by_doubles(a, b);
  return answer && !query::is_empty(b) ? *answer : exactly(a, b, asked);
}
Relation relate(const Triangle3& a, const Aabb3& b, Asked asked) {
  assert_sound_thread();
  const auto answer = query::by_doubles<false>(a, b);
  return answer && !query::is_empty(b) ? *answer : exactly(a, b, asked);
}

}  // namespace plumb
