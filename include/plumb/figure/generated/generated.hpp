// How do generated numbers become shapes?  The structs of figure/ from the rows of numbers of degenerate/shape.hpp.
//
//   Entropy entropy(1, 42);
//   const auto [a, b] = generated_pair<Triangle3, Obb3>(degenerate::Position::edge_along_edge, entropy);
//
// Laws: the numbers are the members, in order, unchanged; points become their convex hull, k-DOPs have 8 directions in
// the plane and 14 in space, and an aabb in another form is what box_forms.hpp makes of it: the same set, of pairs that
// are `exactly` so.  A row that is none of the kind, and points in one plane of which a polyhedron is asked, throw
// InvalidShape.
// Source: RTCD 11.
// Cost: that of copying, or of the hull.  Nothing is searched but by convex_hull (figure/hull/hull3.hpp).
#pragma once

#include <span>
#include <type_traits>
#include <utility>

#include "plumb/degenerate/shape_pair.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/convex_polyhedron.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/mesh.hpp"
#include "plumb/figure/basic/plane.hpp"
#include "plumb/figure/basic/polygon.hpp"
#include "plumb/figure/basic/round.hpp"
#include "plumb/figure/basic/simplex.hpp"
#include "plumb/figure/k_dop/k_dop.hpp"

namespace plumb {

namespace figure::generated {

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
PLUMB_GENERATED(AabbWidths3, aabb, 3)
PLUMB_GENERATED(AabbCenter3, aabb, 3)
PLUMB_GENERATED(Obb2, obb, 2)
PLUMB_GENERATED(Obb3, obb, 3)
PLUMB_GENERATED(Circle2, ball, 2)
PLUMB_GENERATED(Sphere3, ball, 3)
PLUMB_GENERATED(Capsule2, capsule, 2)
PLUMB_GENERATED(Capsule3, capsule, 3)
PLUMB_GENERATED(Lozenge3, lozenge, 3)
PLUMB_GENERATED(Cylinder3, cylinder, 3)
PLUMB_GENERATED(Cone3, cone, 3)
PLUMB_GENERATED(ConvexPolyhedron3, points, 3)
PLUMB_GENERATED(ThreePointPlane3, three_point_plane, 3)
PLUMB_GENERATED(Slab2, slab, 2)
PLUMB_GENERATED(Slab3, slab, 3)
PLUMB_GENERATED(Quadrilateral2, quadrilateral, 2)
PLUMB_GENERATED(Quadrilateral3, quadrilateral, 3)
PLUMB_GENERATED(HoledPolygon2, holed_polygon, 2)
PLUMB_GENERATED(HoledPolygon3, holed_polygon, 3)
PLUMB_GENERATED(KDop2, k_dop, 2)
PLUMB_GENERATED(KDop3, k_dop, 3)
PLUMB_GENERATED(HalfspaceIntersection2, halfspaces, 2)
PLUMB_GENERATED(HalfspaceIntersection3, halfspaces, 3)
PLUMB_GENERATED(TriangleMesh, mesh, 3)
PLUMB_GENERATED(Ellipsoid3, ellipsoid, 3)
#undef PLUMB_GENERATED

/// A row of numbers that is none of the kind throws InvalidShape.
void demand(std::span<const double> numbers, degenerate::ShapeKind kind, int dimension);

/// Whether the numbers are those of the struct, one by one.
template <class Shape>
inline constexpr bool is_copied =
    std::is_trivially_copyable_v<Shape> && !std::is_same_v<Shape, AabbWidths3> && !std::is_same_v<Shape, AabbCenter3>;

/// The others.
template <class Shape>
Shape made(std::span<const double> numbers);
template <>
AabbWidths3 made(std::span<const double> numbers);
template <>
AabbCenter3 made(std::span<const double> numbers);
template <>
Polygon2 made(std::span<const double> numbers);
template <>
Polygon3 made(std::span<const double> numbers);
template <>
HoledPolygon2 made(std::span<const double> numbers);
template <>
HoledPolygon3 made(std::span<const double> numbers);
template <>
KDop2 made(std::span<const double> numbers);
template <>
KDop3 made(std::span<const double> numbers);
template <>
HalfspaceIntersection2 made(std::span<const double> numbers);
template <>
HalfspaceIntersection3 made(std::span<const double> numbers);
template <>
ConvexPolyhedron3 made(std::span<const double> numbers);
template <>
TriangleMesh made(std::span<const double> numbers);

}  // namespace figure::generated

/// A struct whose numbers the generators make.
template <class Shape>
concept GeneratedShape = requires {
  figure::generated::Traits<Shape>::kind;
};
template <GeneratedShape Shape>
inline constexpr degenerate::ShapeKind generated_kind = figure::generated::Traits<Shape>::kind;
template <GeneratedShape Shape>
inline constexpr int generated_dimension = figure::generated::Traits<Shape>::dimension;

template <GeneratedShape Shape>
Shape shape_from(std::span<const double> x) {
  figure::generated::demand(x, generated_kind<Shape>, generated_dimension<Shape>);
  if constexpr (figure::generated::is_copied<Shape>) {
    Shape shape{};
    __builtin_memcpy(&shape, x.data(), sizeof shape);
    return shape;
  } else {
    return figure::generated::made<Shape>(x);
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

/// In any of the positions of a ball and a halfspace: half of it, a point where they touch, all of it, nothing.
inline SphericalCap3 generated_cap(Entropy& entropy) {
  const auto [sphere, halfspace] = generated_pair<Sphere3, Halfspace3>(entropy);
  return {sphere, halfspace};
}

}  // namespace plumb
