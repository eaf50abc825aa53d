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

PLUMB_PAIR_ANSWER(Line2, Line2, relate_given2)
PLUMB_PAIR_ANSWER(Line2, Ray2, relate_given2)
PLUMB_PAIR_ANSWER(Line2, Segment2, relate_given2)
PLUMB_PAIR_ANSWER(Line2, Triangle2, relate_given2)
PLUMB_PAIR_ANSWER(Line2, Aabb2, relate_given2)
PLUMB_PAIR_ANSWER(Ray2, Ray2, relate_given2)
PLUMB_PAIR_ANSWER(Ray2, Segment2, relate_given2)
PLUMB_PAIR_ANSWER(Ray2, Triangle2, relate_given2)
PLUMB_PAIR_ANSWER(Ray2, Aabb2, relate_given2)
PLUMB_PAIR_ANSWER(Segment2, Segment2, relate_quickly2)
PLUMB_PAIR_ANSWER(Segment2, Triangle2, relate_quickly2)
PLUMB_PAIR_ANSWER(Segment2, Aabb2, relate_to_aabb2)
PLUMB_PAIR_ANSWER(Triangle2, Triangle2, relate_quickly2)
PLUMB_PAIR_ANSWER(Triangle2, Aabb2, relate_to_aabb2)

}  // namespace query

}  // namespace plumb
