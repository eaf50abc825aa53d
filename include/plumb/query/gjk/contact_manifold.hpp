// Contact manifold: where do two convex bodies touch, as a whole?  The polygon, edge or point that they have in common; of
// bodies that are apart, all of their nearest pairs.
//
//   const ContactManifold m = contact_manifold(box, polyhedron);
//   approximate(m.on_a)                                  the corners, each the nearest double
//
// Bodies without a radius: points, segments, triangles, convex polygons, boxes of both kinds, rectangles, tetrahedra,
// polytopes with faces or by vertices alone, as they stand or under a pose.
// Laws: (1) `on_a` is the set of all points of a that are as near to b as any, `on_b` that of b's, in real arithmetic and with
// exact corners, told as query/section/intersection_result.hpp says; corner i of one and corner i of the other are a pair, as
// all nearest pairs lie in one direction.  (2) Of bodies that touch both are what they have in common: the part of one face
// that is in another, in the plane between them.  (3) Solids whose insides meet have no manifold: the kind is `solid`, without
// corners; query/section/solid.hpp tells those.  What is flat and crosses something has what both have in common.
// (4) Naming the bodies the other way round swaps the answer.
// NaN and infinity throw NonFinite, empty bodies and polygons that are not planar and convex InvalidShape, by name.
// Source: RTCD 9.5.3; the faces at a plane between bodies that touch are those of a linear program's optimum: Chvatal, Linear
// Programming, 1983.
// Cost: rationals: a millisecond and more with each corner of a face; of hulls of points and of flat bodies that cross
// something the corners of both count.  Exponents that span all doubles take some forty times as long, 0.2 s for hulls of
// nine points: products grow with the square of the span, the steps do not.
#pragma once

#include "plumb/query/section/intersection_result.hpp"
#include "plumb/query/separation/convex_body.hpp"
#include "plumb/query/separation/separation.hpp"

namespace plumb {

struct ContactManifold {
  Intersection3 on_a, on_b;
  bool meets = false;
  double distance = 0;  // rounded once
};

/// A convex body that is the hull of its corners.
template <class Body>
concept Polytope3 = ConvexBody3<Body> &&
    (query::is_vertex_hull<query::UnposedType<Body>> || !query::is_round<query::UnposedType<Body>>);

namespace query {

ContactManifold manifold_of(const BodyView& a, const BodyView& b);

}  // namespace query

template <Polytope3 A, Polytope3 B>
ContactManifold contact_manifold(const A& a, const B& b) {
  return query::manifold_of(query::body_view(a), query::body_view(b));
}

}  // namespace plumb
