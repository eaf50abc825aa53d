// What is straight in space: among itself, and with triangles.
#include "plumb/query/overlap/triangle.hpp"
#include "query/body/figure_input.hpp"
#include "query/overlap/filters.hpp"
#include "query/overlap/lattice3.hpp"
#include "query/overlap/signs.hpp"

namespace plumb {
namespace {

template <class A>
[[gnu::noinline]] Relation exactly(const A& a, const Triangle3& b, Asked asked) {
  if constexpr (std::is_same_v<A, Segment3>) {
    if (const auto answer = query::by_lattice(a, b)) return *answer;
  }
  query::require_figures(asked, a, b);
  return query::relate(query::linear(a), b);
}

template <class A>
Relation related(const A& a, const Triangle3& b, Asked asked) {
  assert_sound_thread();
  if (const auto answer = query::by_doubles(a, b)) return *answer;
  return exactly(a, b, asked);
}
template <class A, class B>
Relation related(const A& a, const B& b, Asked asked) {
  query::require_figures(asked, a, b);
  return query::relate(query::linear(a), query::linear(b));
}

}  // namespace

Relation relate(const Line3& a, const Triangle3& b, Asked asked) { return related(a, b, asked); }
Relation relate(const Ray3& a, const Triangle3& b, Asked asked) { return related(a, b, asked); }
Relation relate(const Segment3& a, const Triangle3& b, Asked asked) { return related(a, b, asked); }

Relation relate(const Line3& a, const Line3& b, Asked asked) { return related(a, b, asked); }
Relation relate(const Line3& a, const Ray3& b, Asked asked) { return related(a, b, asked); }
Relation relate(const Line3& a, const Segment3& b, Asked asked) { return related(a, b, asked); }
Relation relate(const Ray3& a, const Ray3& b, Asked asked) { return related(a, b, asked); }
Relation relate(const Ray3& a, const Segment3& b, Asked asked) { return related(a, b, asked); }
Relation relate(const Segment3& a, const Segment3& b, Asked asked) { return related(a, b, asked); }

}  // namespace plumb
