// Quadric against line: which line is asked about a cylinder or cone?  Points and ways over any number type.
//
// Law: with w the way from `from` and h that from `from` to `to`, the shape is 0 <= w . h <= h . h together with
// q(w) <= 0 for the quadratic form of the surface.
// Source: RTCD 5.3.7.
// Cost: none.
#pragma once

#include "arith/vec.hpp"
#include "plumb/arith/rational.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/plane.hpp"
#include "plumb/figure/basic/relation.hpp"
#include "query/body/round_axis.hpp"

namespace plumb::query {

/// All from + t along, from t = 0 where it has a start, up to t = 1 where it has an end.
template <class T>
struct StraightAxis {
  arith::Vec<T> from, along;
  bool has_start, has_end;
};

template <class T>
StraightAxis<T> straight(const Line3& line) {
  return {arith::vec<T>(line.point), arith::vec<T>(line.direction), false, false};
}
template <class T>
StraightAxis<T> straight(const Ray3& ray) {
  return {arith::vec<T>(ray.origin), arith::vec<T>(ray.direction), true, false};
}
template <class T>
StraightAxis<T> straight(const Segment3& s) {
  const arith::Vec<T> a = arith::vec<T>(s.a);
  return {a, arith::vec<T>(s.b) - a, true, true};
}
/// Of three points on one line, which are not all equal.
template <class T>
StraightAxis<T> straight(const ThreePointPlane3& line) {
  const arith::Vec<T> a = arith::vec<T>(line.a);
  return {a, arith::vec<T>(line.a == line.b ? line.c : line.b) - a, false, false};
}

inline bool is_point(const Line3& line) { return line.direction == Vector3{0, 0, 0}; }
inline bool is_point(const Ray3& ray) { return ray.direction == Vector3{0, 0, 0}; }
inline bool is_point(const Segment3& s) { return s.a == s.b; }
inline bool is_point(const ThreePointPlane3& plane) { return plane.a == plane.b && plane.a == plane.c; }

/// Of exact numbers, against a shape that is itself.
Relation relate_exact_line(const StraightAxis<Rational>& line, const RoundAxis& shape);
/// All x with normal . x - offset = 0, or <= 0; the normal is not zero.
struct ExactPlane {
  arith::Vec<Rational> normal;
  Rational offset;
  bool is_halfspace;
};
Relation relate_exact_plane(const ExactPlane& plane, const RoundAxis& shape);

}  // namespace plumb::query
