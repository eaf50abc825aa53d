#include "plumb/query/overlap2.hpp"

#include "figure_input.hpp"
#include "overlap_shapes2.hpp"

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
Relation relate(const Segment2& a, const Segment2& b, Asked asked) {
  assert_sound_thread();
  using predicates::Orient2d;
  const auto side = [](const Segment2& s, const Point2& p) {
    return filter<Orient2d>(coordinates_of<Orient2d>(s.a, s.b, p));
  };
  const int c = side(a, b.a), d = side(a, b.b), e = side(b, a.a), f = side(b, a.b);  // zero where doubles do not tell
  if (c * d * e * f == 0) return related(a, b, asked);
  return c != d && e != f ? Relation::overlapping : Relation::disjoint;
}
Relation relate(const Segment2& a, const Triangle2& b, Asked asked) { return related(a, b, asked); }
Relation relate(const Segment2& a, const Aabb2& b, Asked asked) { return related(a, b, asked); }
Relation relate(const Triangle2& a, const Triangle2& b, Asked asked) { return related(a, b, asked); }
Relation relate(const Triangle2& a, const Aabb2& b, Asked asked) { return related(a, b, asked); }

}  // namespace plumb
