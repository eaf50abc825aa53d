#include "plumb/query/overlap/overlap2.hpp"

#include "query/body/figure_input.hpp"
#include "query/overlap/quick2.hpp"
#include "query/overlap/shapes2.hpp"

namespace plumb {
namespace {

template <class A, class B>
Relation related(const A& a, const B& b, Asked asked) {
  query::require_figures(asked, a, b);
  if constexpr (requires { query::linear(b); }) {
    return query::relate(query::linear(a), query::linear(b));
  } else if constexpr (requires { query::linear(a); }) {
    return query::relate(query::linear(a), b);
  } else {
    return query::relate(a, b);
  }
}

template <class A, class B>
Relation quickly_related(const A& a, const B& b, Asked asked) {
  assert_sound_thread();
  if (const auto answer = query::quickly(a, b)) return *answer;
  return related(a, b, asked);
}

}  // namespace

Relation relate(const Line2& a, const Line2& b, Asked asked) { return related(a, b, asked); }
Relation relate(const Line2& a, const Ray2& b, Asked asked) { return related(a, b, asked); }
Relation relate(const Line2& a, const Segment2& b, Asked asked) { return related(a, b, asked); }
Relation relate(const Line2& a, const Triangle2& b, Asked asked) { return related(a, b, asked); }
Relation relate(const Line2& a, const Aabb2& b, Asked asked) { return related(a, b, asked); }
Relation relate(const Ray2& a, const Ray2& b, Asked asked) { return related(a, b, asked); }
Relation relate(const Ray2& a, const Segment2& b, Asked asked) { return related(a, b, asked); }
Relation relate(const Ray2& a, const Triangle2& b, Asked asked) { return related(a, b, asked); }
Relation relate(const Ray2& a, const Aabb2& b, Asked asked) { return related(a, b, asked); }
Relation relate(const Segment2& a, const Segment2& b, Asked asked) { return quickly_related(a, b, asked); }
Relation relate(const Segment2& a, const Triangle2& b, Asked asked) { return quickly_related(a, b, asked); }
Relation relate(const Segment2& a, const Aabb2& b, Asked asked) { return related(a, b, asked); }
Relation relate(const Triangle2& a, const Triangle2& b, Asked asked) { return quickly_related(a, b, asked); }
Relation relate(const Triangle2& a, const Aabb2& b, Asked asked) { return related(a, b, asked); }

}  // namespace plumb
