// What is straight in space: among itself, and with triangles.
#include "query/body/figure_input.hpp"
#include "query/overlap/filters.hpp"
#include "query/overlap/lattice3.hpp"
#include "query/overlap/pair_answer.hpp"
#include "query/overlap/signs.hpp"

namespace plumb {
namespace {

template <class A>
[[gnu::noinline]] Relation exactly(const A& a, const Triangle3& b, query::Question question) {
  if constexpr (std::is_same_v<A, Segment3>) {
    if (const auto answer = query::by_lattice(a, b)) return *answer;
  }
  query::require_figures(question, a, b);
  return query::relate(query::linear(a), b);
}

template <class A>
Relation relate_given3(const A& a, const Triangle3& b, query::Question question) {
  assert_sound_thread();
  if (const auto answer = query::by_doubles(a, b)) return *answer;
  return exactly(a, b, question);
}
template <class A, class B>
Relation relate_given3(const A& a, const B& b, query::Question question) {
  query::require_figures(question, a, b);
  return query::relate(query::linear(a), query::linear(b));
}

}  // namespace

namespace query {

PLUMB_PAIR_ANSWERS_OF(Line3, relate_given3, Triangle3, Line3, Ray3, Segment3)
PLUMB_PAIR_ANSWERS_OF(Ray3, relate_given3, Triangle3, Ray3, Segment3)
PLUMB_PAIR_ANSWERS_OF(Segment3, relate_given3, Triangle3, Segment3)

}  // namespace query

}  // namespace plumb
