// Triangles against lines, rays, segments and triangles.
#include "plumb/query/closest_pairs.hpp"
#include "query/straight_input.hpp"
#include "query/straight_search.hpp"

namespace plumb {
namespace {

using namespace query;

template <class T, class A, class B>
std::optional<Found<T>> found_over(const A& a, const B& b) {
  Signs ask;
  const Body<T> p = body_of<T>(a, ask), q = body_of<T>(b, ask);
  const auto found = closest_features(p, q, ask);
  if (ask.certain()) return found;
  return {};
}

template <class A, class B>
Found<BigDyadic> exactly(const A& a, const B& b) {
  return *found_over<BigDyadic>(a, b);
}

template <class A, class B>
Closest closest_of(const A& a, const B& b) {
  require_finite_shapes("closest_points", a, b);
  if (const auto quick = found_over<Ball>(a, b)) {
    const auto p = nearest_point(quick->pair.a), q = nearest_point(quick->pair.b);
    const auto d = nearest_distance(quick->pair);
    if (p && q && d) return {*p, *q, *d, quick->a, quick->b};
  }
  const Found<BigDyadic> f = exactly(a, b);
  return {nearest_point(f.pair.a), nearest_point(f.pair.b), nearest_distance(f.pair), f.a, f.b};
}

template <class A, class B>
double distance_of(const A& a, const B& b) {
  require_finite_shapes("distance", a, b);
  if (const auto quick = found_over<Ball>(a, b)) {
    if (const auto d = nearest_distance(quick->pair)) return *d;
  }
  return nearest_distance(exactly(a, b).pair);
}

template <class A, class B>
Rational square_exactly(const A& a, const B& b) {
  require_finite_shapes("squared_distance_exact", a, b);
  return square_of(exactly(a, b).pair);
}

// The plane is a plane of space.
Point3 lifted(const Point2& p) { return {p.x, p.y, 0}; }
Vector3 lifted(const Vector2& v) { return {v.x, v.y, 0}; }
Line3 lifted(const Line2& l) { return {lifted(l.point), lifted(l.direction)}; }
Ray3 lifted(const Ray2& r) { return {lifted(r.origin), lifted(r.direction)}; }
Segment3 lifted(const Segment2& s) { return {lifted(s.a), lifted(s.b)}; }
Triangle3 lifted(const Triangle2& t) { return {lifted(t.a), lifted(t.b), lifted(t.c)}; }

}  // namespace

template <class A, class B>
requires StraightPair3<A, B> Closest closest_points(const A& a, const B& b) { return closest_of(a, b); }
template <class A, class B>
requires StraightPair2<A, B> Closest2 closest_points(const A& a, const B& b) {
  const Closest c = closest_of(lifted(a), lifted(b));
  return {{c.on_a.x, c.on_a.y}, {c.on_b.x, c.on_b.y}, c.distance, c.feature_a, c.feature_b};
}

template <class A, class B>
requires query::StraightPair<A, B>
double distance(const A& a, const B& b) {
  if constexpr (is_in_space<A>) {
    return distance_of(a, b);
  } else {
    return distance_of(lifted(a), lifted(b));
  }
}

template <class A, class B>
requires query::StraightPair<A, B> Rational squared_distance_exact(const A& a, const B& b) {
  if constexpr (is_in_space<A>) {
    return square_exactly(a, b);
  } else {
    return square_exactly(lifted(a), lifted(b));
  }
}

#define PLUMB_TRIANGLE_PAIR(Result, A, B)             \
  template Result closest_points(const A&, const B&); \
  template double distance(const A&, const B&);       \
  template Rational squared_distance_exact(const A&, const B&);
PLUMB_TRIANGLE_PAIR(Closest2, Line2, Triangle2)
PLUMB_TRIANGLE_PAIR(Closest2, Ray2, Triangle2)
PLUMB_TRIANGLE_PAIR(Closest2, Segment2, Triangle2)
PLUMB_TRIANGLE_PAIR(Closest2, Triangle2, Triangle2)
PLUMB_TRIANGLE_PAIR(Closest, Line3, Triangle3)
PLUMB_TRIANGLE_PAIR(Closest, Ray3, Triangle3)
PLUMB_TRIANGLE_PAIR(Closest, Segment3, Triangle3)
PLUMB_TRIANGLE_PAIR(Closest, Triangle3, Triangle3)
#undef PLUMB_TRIANGLE_PAIR

}  // namespace plumb
