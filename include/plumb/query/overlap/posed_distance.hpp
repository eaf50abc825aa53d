// Distance of moved figures: how far apart are figures under poses?  In the space that the poses lead to.
//
//   distance(Posed{point, pose}, Posed{triangle, other})   the number; exact_distance and squared_distance_exact without
//                                                           rounding; compare_distance compares
//
// Laws: the distance of the exact images, rounded once to the nearest double, of every pair that distance answers
// without poses, one or both posed, in either order; zero where they meet.  What a singular matrix flattens is the flat
// figure that it becomes.  A common RigidPose, or a Pose that turns and mirrors alone, exactly, changes no answer.  closest_points takes
// posed triangles, and one of them and a point, here; any pair in query/separation/posed.hpp.
// Round figures take rigid poses, and those whose columns are at right angles and of one length, which is rational, exactly: UnevenPose
// else.  An empty figure throws InvalidShape, NaN and infinity NonFinite, by name.
// Source: RTCD 3.2, 5.1.
// Cost: boxes, capsules and balls under rigid poses 0.4 us, under a chain 0.5 us a link more; polyhedra some microseconds;
// rationals else: some 20 us for a point and a triangle, of polygons times the square of their corners.  Bounded by
// n^2 pairs of features, on integers as long as the exponents' span.
#pragma once

#include "plumb/query/body/posed.hpp"
#include "plumb/query/closest/closest.hpp"

namespace plumb {

namespace query {

Closest posed_closest_points(const Posed<Triangle3>& a, const Posed<Triangle3>& b);
Closest posed_closest_points(const Point3& p, const Posed<Triangle3>& triangle);
double posed_distance(const PosedView& a, const PosedView& b, Question question);
ExactDistance posed_exact_distance(const PosedView& a, const PosedView& b, Question question);

template <class A, class B>
concept PosedMeasured = PosedFigures<A, B> && requires(const UnposedType<A>& a, const UnposedType<B>& b) {
  { distance(a, b) } -> std::same_as<double>;
};
template <class A, class B>
concept PosedFlatMeasured = PosedMeasured<A, B> && requires(const UnposedType<A>& a, const UnposedType<B>& b) {
  { squared_distance_exact(a, b) } -> std::same_as<Rational>;
};

template <class A, class B>
requires PosedMeasured<A, B>
double distance_as(Question question, const A& a, const B& b) {
  return posed_distance(posed_view(a), posed_view(b), question);
}

}  // namespace query

template <class A, class B>
requires query::PosedMeasured<A, B>
double distance(const A& a, const B& b) { return query::distance_as(query::Question::distance, a, b); }

template <class A, class B>
requires query::PosedFlatMeasured<A, B> Rational squared_distance_exact(const A& a, const B& b) {
  return query::posed_exact_distance(query::posed_view(a), query::posed_view(b),
                                     query::Question::squared_distance_exact)
      .square;
}

template <class A, class B>
requires query::PosedMeasured<A, B> ExactDistance exact_distance(const A& a, const B& b) {
  return query::posed_exact_distance(query::posed_view(a), query::posed_view(b), query::Question::exact_distance);
}

/// Points and features as well, of triangles and points.
template <std::same_as<Triangle3> Shape>
Closest closest_points(const Posed<Shape>& a, const Posed<Shape>& b) {
  return query::posed_closest_points(a, b);
}
template <std::same_as<Triangle3> Shape>
Closest closest_points(const Point3& p, const Posed<Shape>& triangle) {
  return query::posed_closest_points(p, triangle);
}
template <std::same_as<Triangle3> Shape>
Closest closest_points(const Posed<Shape>& triangle, const Point3& p) {
  return swapped(query::posed_closest_points(p, triangle));
}

}  // namespace plumb
