// Ray cast: where does a ray, a segment or a line of the plane first hit a shape?  The parameter, point, feature and a
// normal.
//
//   first_hit(Ray2{origin, direction}, polygon)       nothing, or { t, point, feature, normal }
//
// Laws: those of query/ray/ray.hpp, in the plane: whether there is a hit and at which feature is exact, numbers are exact
// ones rounded once.  Shapes are closed sets; what begins inside one hits it at t = 0, at face 0, without a normal.
// Features: a triangle's vertices are a, b, c and its edges ab, bc, ca; a polygon's count through its chains, an edge
// by the vertex that it leaves; a box's vertex bits are its ends, an edge is 2 times its axis, plus 1 at the upper end
// of the other, also of an oriented one; slab i of a k-DOP has the edges 2 i at its min and 2 i + 1 at its max, and no
// vertices; a segment's vertices are a and b; a circle is edge 0, a capsule's sides are edge 0, its rounds about a
// and b edges 1 and 2.
// A normal is not normalized, and faces the ray: it is perpendicular to the first edge that holds the point and that
// the ray does not run along, as long as the edge; zero where there is none.  Of circles and capsules it is the way
// from the center or the axis to the point, of a k-DOP the direction of the slab, out of it.
// A negative radius or a chain of fewer than three vertices throws InvalidShape, NaN and infinity NonFinite, by name.
// Source: RTCD 5.1.9.1, 5.3, 5.3.2, 5.3.3.
// Cost: some 0.3 us a hit of a straight edge, 50 ns for each edge that is missed; microseconds where pairs of doubles
// leave a doubt.  Bounded by n signs for n corners, on integers as long as the exponents' span.
#pragma once

#include <optional>

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/polygon.hpp"
#include "plumb/figure/basic/round.hpp"
#include "plumb/figure/basic/simplex.hpp"
#include "plumb/query/ray/ray.hpp"

namespace plumb {

struct Hit2 {
  double t;
  Point2 point;
  Feature feature;
  Vector2 normal;
  friend bool operator==(const Hit2&, const Hit2&) = default;
};

/// A ray, a segment or a line of the plane; made of one without a word.
struct AnyRay2 {
  AnyRay::Kind kind;
  Point2 origin;
  Vector2 direction;  // unused by segments, of which the difference of the ends is not rounded
  Point2 end;         // of a segment

  AnyRay2(const Ray2& r)
      : kind(AnyRay::Kind::ray), origin(r.origin), direction(r.direction), end(r.origin) {}            // NOLINT
  AnyRay2(const Segment2& s) : kind(AnyRay::Kind::segment), origin(s.a), direction{0, 0}, end(s.b) {}  // NOLINT
  AnyRay2(const Line2& l)
      : kind(AnyRay::Kind::line), origin(l.point), direction(l.direction), end(l.point) {}  // NOLINT
};

namespace query {

template <class Shape>
concept SeenInPlane = SeenByRays<Shape, 2>;

/// Compiled for each of them (src/query/ray/ray2.cpp).
template <class Shape>
struct RayAnswers2 {
  static std::optional<Hit2> first_hit(const AnyRay2& ray, const Shape& shape);
  static std::optional<RayParameter> first_hit_parameter(const AnyRay2& ray, const Shape& shape);
  static bool hits(const AnyRay2& ray, const Shape& shape);
};

}  // namespace query

template <query::SeenInPlane Shape>
std::optional<Hit2> first_hit(const AnyRay2& ray, const Shape& shape) {
  return query::RayAnswers2<Shape>::first_hit(ray, shape);
}

/// The exact t of first_hit.
template <query::SeenInPlane Shape>
std::optional<RayParameter> first_hit_parameter(const AnyRay2& ray, const Shape& shape) {
  return query::RayAnswers2<Shape>::first_hit_parameter(ray, shape);
}

}  // namespace plumb
