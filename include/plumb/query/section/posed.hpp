// Intersection of moved figures: which points do figures under poses have in common?  With exact corners.
//
//   intersection(Posed{triangle, pose}, Posed{other, pose})   the image of what they have in common
//
// Laws: those of query/section/intersection.hpp, intersection2.hpp, solid.hpp and, of two planes, planes.hpp, of
// the exact images, in every pair of theirs, one or both posed, in either order.  What a singular matrix flattens is the flat
// figure that it becomes.  Corners that are no doubles are held as rational points.
// A polygon that is not convex throws InvalidShape, NaN and infinity NonFinite, by name.
// Source: RTCD 3.2, 5.3.
// Cost: rationals: some 200 us for triangles and boxes, of polyhedra more with each corner.  Bounded by n^2
// operations for n corners of both, on integers as long as the exponents' span.
#pragma once

#include "plumb/query/body/posed.hpp"
#include "plumb/query/section/intersection.hpp"
#include "plumb/query/section/intersection2.hpp"
#include "plumb/query/section/planes.hpp"
#include "plumb/query/section/solid.hpp"

namespace plumb {

namespace query {

Intersection2 posed_intersection2(const PosedView& a, const PosedView& b);
Intersection3 posed_intersection3(const PosedView& a, const PosedView& b);

template <class Answer>
concept SectionAnswer = std::same_as<Answer, Intersection2> || std::same_as<Answer, Intersection3>;

template <class A, class B>
concept PosedSection = PosedFigures<A, B> && requires(const UnposedType<A>& a, const UnposedType<B>& b) {
  { intersection(a, b) } -> SectionAnswer;
};

FlatIntersection posed_planes(const PosedView& a, const PosedView& b);

template <class A, class B>
concept PosedPlanes = PosedFigures<A, B> && figure_dimension<UnposedType<A>>
== 3 && is_plane_kind(figure_kind<UnposedType<A>>) && is_plane_kind(figure_kind<UnposedType<B>>);

SolidIntersection3 posed_solid(const PosedView& a, const PosedView& b);

template <class A, class B>
concept PosedSolids = PosedFigures<A, B> && SolidFigure<UnposedType<A>> && SolidFigure<UnposedType<B>>;

}  // namespace query

/// Of two solids; their volumes are multiplied by the pose's determinant.
template <class A, class B>
requires query::PosedSolids<A, B> SolidIntersection3 intersection(const A& a, const B& b) {
  return query::posed_solid(query::posed_view(a), query::posed_view(b));
}

template <class A, class B>
requires query::PosedPlanes<A, B> FlatIntersection intersection(const A& a, const B& b) {
  return query::posed_planes(query::posed_view(a), query::posed_view(b));
}

template <class A, class B>
requires query::PosedSection<A, B>
auto intersection(const A& a, const B& b) {
  if constexpr (figure_dimension<query::UnposedType<A>> == 2) {
    return query::posed_intersection2(query::posed_view(a), query::posed_view(b));
  } else {
    return query::posed_intersection3(query::posed_view(a), query::posed_view(b));
  }
}

}  // namespace plumb
