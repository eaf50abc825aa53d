#include "query/body/figure_input.hpp"
#include "query/overlap/box_quick.hpp"
#include "query/overlap/pair_answer.hpp"
#include "query/overlap/quick2.hpp"
#include "query/overlap/shapes2.hpp"

namespace plumb {
namespace {

template <class A, class B>
Relation relate_given2(const A& a, const B& b, query::Question question) {
  query::require_figures(question, a, b);
  if constexpr (requires { query::linear(b); }) {
    return query::relate(query::linear(a), query::linear(b));
  } else if constexpr (requires { query::linear(a); }) {
    return query::relate(query::linear(a), b);
  } else {
    return query::relate(a, b);
  }
}

template <class A, class B>
Relation relate_quickly2(const A& a, const B& b, query::Question question) {
  assert_sound_thread();
  if (const auto answer = query::quickly(a, b)) return *answer;
  return relate_given2(a, b, question);
}
template <class A>
Relation relate_to_aabb2(const A& a, const Aabb2& b, query::Question question) {
  assert_sound_thread();
  if (const auto answer = query::quick_relation(a, b)) [[likely]]
    return *answer;
  return relate_given2(a, b, question);
}

}  // namespace

namespace query {

PLUMB_PAIR_ANSWERS_OF(Line2, relate_given2, Line2, Ray2, Segment2, Triangle2, Aabb2)
PLUMB_PAIR_ANSWERS_OF(Ray2, relate_given2, Ray2, Segment2, Triangle2, Aabb2)
PLUMB_PAIR_ANSWERS_OF(Segment2, relate_quickly2, Segment2, Triangle2)
PLUMB_PAIR_ANSWERS_TO(Aabb2, relate_to_aabb2, Segment2, Triangle2)
PLUMB_PAIR_ANSWER(Triangle2, Triangle2, relate_quickly2)

}  // namespace query

}  // namespace plumb
