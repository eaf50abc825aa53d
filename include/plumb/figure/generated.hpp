// How do generated numbers become shapes?  The structs of figure/ from the rows of numbers of degenerate/shape.hpp.
//
//   Entropy entropy(1, 42);
//   const auto [a, b] = generated_pair<Triangle3, Obb3>(degenerate::Position::edge_along_edge, entropy);
//
// Laws: the numbers are the members, in order, unchanged; points become their convex hull or the k-DOP of 14 directions
// around them, whose intervals are exact where the sums of the coordinates are doubles, as those of pairs that are
// `exactly` so.  A row of the wrong length, and points in one plane of which a polyhedron is asked, throw InvalidShape.
// Source: RTCD 11.  Cost: that of copying, or of the hull.
#pragma once

#include <span>
#include <utility>

#include "plumb/degenerate/shape_pair.hpp"
#include "plumb/figure/box.hpp"
#include "plumb/figure/convex_polyhedron.hpp"
#include "plumb/figure/k_dop.hpp"
#include "plumb/figure/linear.hpp"
#include "plumb/figure/plane.hpp"
#include "plumb/figure/polygon.hpp"
#include "plumb/figure/round.hpp"
#include "plumb/figure/simplex.hpp"

namespace plumb {

namespace generated {

template <class Shape>
struct Traits;
#define PLUMB_GENERATED(shape, k, d)                                        \
  template <>                                                               \
  struct Traits<shape> {                                                    \
    static constexpr degenerate::ShapeKind kind = degenerate::ShapeKind::k; \
    static constexpr int dimension = d;                                     \
  };
PLUMB_GENERATED(Point2, point, 2)
PLUMB_GENERATED(Point3, point, 3)
PLUMB_GENERATED(Line2, line, 2)
PLUMB_GENERATED(Line3, line, 3)
PLUMB_GENERATED(Ray2, ray, 2)
PLUMB_GENERATED(Ray3, ray, 3)
PLUMB_GENERATED(Segment2, segment, 2)
PLUMB_GENERATED(Segment3, segment, 3)
PLUMB_GENERATED(Plane3, plane, 3)
PLUMB_GENERATED(Halfspace2, halfspace, 2)
PLUMB_GENERATED(Halfspace3, halfspace, 3)
PLUMB_GENERATED(Triangle2, triangle, 2)
PLUMB_GENERATED(Triangle3, triangle, 3)
PLUMB_GENERATED(Polygon2, polygon, 2)
PLUMB_GENERATED(Polygon3, polygon, 3)
PLUMB_GENERATED(Rectangle3, rectangle, 3)
PLUMB_GENERATED(Tetrahedron3, tetrahedron, 3)
PLUMB_GENERATED(Aabb2, aabb, 2)
PLUMB_GENERATED(Aabb3, aabb, 3)
PLUMB_GENERATED(Obb2, obb, 2)
PLUMB_GENERATED(Obb3, obb, 3)
PLUMB_GENERATED(Circle2, ball, 2)
PLUMB_GENERATED(Sphere3, ball, 3)
PLUMB_GENERATED(Capsule2, capsule, 2)
PLUMB_GENERATED(Capsule3, capsule, 3)
PLUMB_GENERATED(Lozenge3, lozenge, 3)
PLUMB_GENERATED(Cylinder3, cylinder, 3)
PLUMB_GENERATED(Cone3, cone, 3)
PLUMB_GENERATED(KDop2, points, 2)
PLUMB_GENERATED(KDop3, points, 3)
PLUMB_GENERATED(ConvexPolyhedron3, points, 3)
#undef PLUMB_GENERATED

Polygon2 polygon2(std::span<const double> numbers);
Polygon3 polygon3(std::span<const double> numbers);
KDop2 k_dop2(std::span<const double> numbers);
KDop3 k_dop3(std::span<const double> numbers);
ConvexPolyhedron3 polyhedron(std::span<const double> numbers);
void demand(std::span<const double> numbers, degenerate::ShapeKind kind, int dimension);

}  // namespace generated

/// A struct whose numbers the generators make.
template <class Shape>
concept GeneratedShape = requires {
  generated::Traits<Shape>::kind;
};
template <GeneratedShape Shape>
inline constexpr degenerate::ShapeKind generated_kind = generated::Traits<Shape>::kind;
template <GeneratedShape Shape>
inline constexpr int generated_dimension = generated::Traits<Shape>::dimension;

template <GeneratedShape Shape>
Shape shape_from(std::span<const double> x) {
  using degenerate::ShapeKind;
  constexpr ShapeKind kind = generated_kind<Shape>;
  constexpr int dimension = generated_dimension<Shape>;
  generated::demand(x, kind, dimension);
  if constexpr (std::is_same_v<Shape, Polygon2>) {
    return generated::polygon2(x);
  } else if constexpr (std::is_same_v<Shape, Polygon3>) {
    return generated::polygon3(x);
  } else if constexpr (std::is_same_v<Shape, KDop2>) {
    return generated::k_dop2(x);
  } else if constexpr (std::is_same_v<Shape, KDop3>) {
    return generated::k_dop3(x);
  } else if constexpr (std::is_same_v<Shape, ConvexPolyhedron3>) {
    return generated::polyhedron(x);
  } else if constexpr (kind == ShapeKind::obb && dimension == 2) {
    return {{x[0], x[1]}, {{{x[2], x[3]}, {x[4], x[5]}}}, {x[6], x[7]}};
  } else if constexpr (kind == ShapeKind::obb) {
    return {
        {x[0], x[1], x[2]}, {{{x[3], x[4], x[5]}, {x[6], x[7], x[8]}, {x[9], x[10], x[11]}}}, {x[12], x[13], x[14]}};
  } else if constexpr (kind == ShapeKind::rectangle) {
    return {{x[0], x[1], x[2]}, {{{x[3], x[4], x[5]}, {x[6], x[7], x[8]}}}, {x[9], x[10]}};
  } else if constexpr (kind == ShapeKind::lozenge) {
    return {{x[0], x[1], x[2]}, {{{x[3], x[4], x[5]}, {x[6], x[7], x[8]}}}, x[9]};
  } else if constexpr (sizeof(Shape) == sizeof(double) * 2) {
    return {x[0], x[1]};
  } else if constexpr (std::is_same_v<Shape, Point3>) {
    return {x[0], x[1], x[2]};
  } else if constexpr (kind == ShapeKind::triangle && dimension == 2) {
    return {{x[0], x[1]}, {x[2], x[3]}, {x[4], x[5]}};
  } else if constexpr (kind == ShapeKind::triangle) {
    return {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, {x[6], x[7], x[8]}};
  } else if constexpr (kind == ShapeKind::tetrahedron) {
    return {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, {x[6], x[7], x[8]}, {x[9], x[10], x[11]}};
  } else if constexpr (sizeof(Shape) == sizeof(double) * 3) {
    return {{x[0], x[1]}, x[2]};
  } else if constexpr (dimension == 3 && sizeof(Shape) == sizeof(double) * 4) {
    return {{x[0], x[1], x[2]}, x[3]};
  } else if constexpr (sizeof(Shape) == sizeof(double) * 4) {
    return {{x[0], x[1]}, {x[2], x[3]}};
  } else if constexpr (sizeof(Shape) == sizeof(double) * 5) {
    return {{x[0], x[1]}, {x[2], x[3]}, x[4]};
  } else if constexpr (sizeof(Shape) == sizeof(double) * 6) {
    return {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}};
  } else {
    return {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, x[6]};
  }
}

/// Which positions these can have: degenerate::has_position of their kinds.
template <GeneratedShape A, GeneratedShape B>
bool has_position(degenerate::Position position) {
  return generated_dimension<A> == generated_dimension<B> &&
         degenerate::has_position(generated_kind<A>, generated_kind<B>, generated_dimension<A>, position);
}

template <GeneratedShape A, GeneratedShape B>
requires(generated_dimension<A> ==
         generated_dimension<B>) std::pair<A, B> pair_from(const degenerate::ShapePair& pair) {
  return {shape_from<A>(pair.a), shape_from<B>(pair.b)};
}

/// Exactly so.
template <GeneratedShape A, GeneratedShape B>
requires(generated_dimension<A> == generated_dimension<B>) std::pair<A, B> generated_pair(degenerate::Position position,
                                                                                          Entropy& entropy) {
  return pair_from<A, B>(degenerate::shape_pair(generated_kind<A>, generated_kind<B>, generated_dimension<A>, position,
                                                degenerate::Nearness::exactly, entropy));
}

/// In any position, exactly or nearly so.
template <GeneratedShape A, GeneratedShape B>
requires(generated_dimension<A> == generated_dimension<B>) std::pair<A, B> generated_pair(Entropy& entropy) {
  return pair_from<A, B>(
      degenerate::any_shape_pair(generated_kind<A>, generated_kind<B>, generated_dimension<A>, entropy));
}

}  // namespace plumb
