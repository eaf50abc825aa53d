// Narrow phase of moved figures: do figures under poses meet, and do they overlap or only touch?  Without rounding a
// corner.
//
//   relate(Posed{box, pose}, Posed{triangle, pose})   that of the box and the triangle, whatever the pose
//   contains(Posed{ball, sheared}, p)                 is p in the ellipsoid?
//   contains(Posed{box, pose}, Posed{other, pose})    every point of the other?
//
// Laws: (1) those of query/overlap/overlap.hpp, of the exact images; every pair of the table, one or both posed, in
// either order.  (2) A common pose whose matrix is not singular changes no answer; one that stays changes none.  (3) A
// singular matrix makes the flat figure that it makes: its interior is that of its own affine hull.
// Two balls are answered under any poses that are not singular, two other round figures (capsules, lozenges) where one
// pose is a similarity as seen from the other (its columns at right angles and of one length, exactly), or where one maps
// all to a point; a ball and a cylinder, cone or cap likewise.  Rigid poses leave round what is: every pair has an answer.  What is round and flattened by its pose is not asked of
// polygons, a cylinder, cone or cap flattened so not of balls: UnevenPose.
// contains takes a point, and every pair of figures that it takes without poses.  A round figure in a round one is
// answered where one pose is a similarity as seen from the other, in a flat one under any pose.
// NaN and infinities throw NonFinite, naming the part ("relate: triangle.shape.b.y is nan"), what is no shape throws
// InvalidShape.
// Source: RTCD 3.2, 5.2.
// Cost: some 2 us for points, lines, triangles, tetrahedra and boxes where running errors tell, some 20 us where these
// touch; others in rationals: some 30 us for balls and quadrilaterals, 200 us for cylinders, 500 us for halfspaces.
// Bounded by n^2 signs for n corners of both, on integers as long as the exponents' span.
#pragma once

#include "plumb/figure/aabb/relation.hpp"
#include "plumb/figure/basic/answered.hpp"
#include "plumb/figure/containment/contains.hpp"
#include "plumb/figure/k_dop/k_dop.hpp"
#include "plumb/figure/sphere/sphere.hpp"
#include "plumb/figure/swept_sphere/swept_sphere.hpp"
#include "plumb/query/body/posed.hpp"

namespace plumb {

namespace query {

/// The function is named in what is thrown.
Relation relate_posed(std::string_view function, const PosedView& a, const PosedView& b);

bool posed_contains(const PosedView& outer, const PosedView& inner);
Location posed_locate(const PosedView& figure, const FigureView& point);

template <class A, class B>
concept PosedPair = PosedFigures<A, B> && RelatedPair<UnposedType<A>, UnposedType<B>>;

template <class Outer, class Inner>
concept PosedHolder = PosedFigures<Outer, Inner> && figure_kind<UnposedType<Inner>>
!= FigureKind::point&& requires(const UnposedType<Outer>& outer, const UnposedType<Inner>& inner) {
  { contains(outer, inner) } -> std::same_as<bool>;
};

}  // namespace query

template <class A, class B>
requires query::PosedPair<A, B> Relation relate(const A& a, const B& b) {
  return query::relate_posed("relate", query::posed_view(a), query::posed_view(b));
}

template <class A, class B>
requires query::PosedPair<A, B>
bool intersects(const A& a, const B& b) {
  return query::relate_posed("intersects", query::posed_view(a), query::posed_view(b)) != Relation::disjoint;
}

/// Of a point, posed or not.
template <class Shape, class Point>
requires(query::PosedPair<Shape, Point>&& figure_kind<query::UnposedType<Point>> == FigureKind::point)  //
    bool contains(const Shape& shape, const Point& p) {
  return query::relate_posed("contains", query::posed_view(shape), query::posed_view(p)) != Relation::disjoint;
}

/// As above, though locate takes it as well: of what it tells the name is this one's.
template <class Shape>
requires LocatesPoints<Shape, Point2> && query::is_posed<Shape>
bool contains(const Shape& shape, const Point2& p) {
  return query::relate_posed("contains", query::posed_view(shape), query::posed_view(p)) != Relation::disjoint;
}
template <class Shape>
requires LocatesPoints<Shape, Point3> && query::is_posed<Shape>
bool contains(const Shape& shape, const Point3& p) {
  return query::relate_posed("contains", query::posed_view(shape), query::posed_view(p)) != Relation::disjoint;
}
/// Of what a matrix flattens all is boundary.
template <class Shape, class By, class Point>
requires(PosedOrNot<Posed<Shape, By>>&& LocatesPoints<Shape, Point>) Location
    locate(const Posed<Shape, By>& posed, const Point& p) {
  return query::posed_locate(query::posed_view(posed), query::view_of(p));
}

/// Every point of the inner one?
template <class Outer, class Inner>
requires query::PosedHolder<Outer, Inner>
bool contains(const Outer& outer, const Inner& inner) {
  return query::posed_contains(query::posed_view(outer), query::posed_view(inner));
}

}  // namespace plumb
