// Closest points of moved figures: where do figures under poses come closest?  In the space that the poses lead to.
//
//   closest_points(Posed{box, pose}, polyhedron)      both points, their features, the distance
//
// Laws: (1) those of query/separation/separation.hpp, of the exact images, in every pair that closest_points takes without
// poses, one or both posed, in either order; so of several closest pairs of any two figures that are apart that one is told
// which comes first in lexicographic order.  Of two posed triangles, and of one and a point, it is that of query/closest/pairs.hpp
// (query/overlap/posed_distance.hpp).  (2) A common pose whose numbers are those of a move without rotation changes no
// feature; a feature is the image of what it is without the pose, also where a singular matrix flattens it.
// Round figures take rigid poses, and those whose columns are at right angles and of one length, which is rational, exactly: UnevenPose
// else.  An empty figure and a polygon that is not planar throw InvalidShape, NaN and infinity NonFinite, by name.
// Source: RTCD 3.2, 5.1.
// Cost: boxes, capsules and balls under rigid poses 0.4 us, under a chain 0.5 us a link more; others some microseconds, by
// doubles with a bound; rationals where these do not tell, as of several nearest pairs: some 100 us.
// Bounded by n^2 signs for n corners of both, on integers as long as the exponents' span.
#pragma once

#include "plumb/query/overlap/posed_distance.hpp"
#include "plumb/query/separation/separation.hpp"

namespace plumb {

namespace query {

Closest posed_closest_points(const PosedView& a, const PosedView& b, WhichPair common = WhichPair::first);

template <class A, class B>
concept PosedNear = PosedMeasured<A, B> && requires(const UnposedType<A>& a, const UnposedType<B>& b) {
  closest_points(a, b).on_a;
};

}  // namespace query

template <class A, class B>
requires query::PosedNear<A, B>
auto closest_points(const A& a, const B& b, WhichPair common = WhichPair::any) {
  const Closest c = query::posed_closest_points(query::posed_view(a), query::posed_view(b), common);
  if constexpr (figure_dimension<query::UnposedType<A>> == 2) {
    return Closest2{{c.on_a.x, c.on_a.y}, {c.on_b.x, c.on_b.y}, c.distance, c.feature_a, c.feature_b};
  } else {
    return c;
  }
}

}  // namespace plumb
