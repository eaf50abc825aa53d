// Closest feature, Voronoi region: which vertex, edge or face of a shape is nearest to a point?  The Voronoi region
// that the point is in.
//
// Laws: (1) the feature, of the lowest dimension and then of the lowest number, that contains the one point of the
// convex shape that is nearest to p: so a point on the boundary of two regions is in that of the vertex before that of
// the edge, of the edge before that of the face; and a point of the shape itself is told where it is.  (2) Decided by
// the signs of real arithmetic, whatever the angles: no region is taken for granted where an angle is obtuse.
// (3) Degenerate shapes are shapes: of a triangle that is a segment only vertices and edges are ever nearest; of equal
// corners the first.  (4) The start of the walk about a polyhedron changes the time, never the answer.
// An empty box or polyhedron throws InvalidShape, NaN and infinity NonFinite, by name.
// Source: RTCD 3.10 (figures 3.24, 3.25), 5.1.5 (figures 5.5, 5.6).
// Cost: a triangle 2 to 9 signs of degree 2 to 4; an axis-aligned box comparisons only; an oriented box up to a hundred
// signs; a polyhedron a walk.  Bounded by n signs of a polyhedron, on integers as long as the exponents' span: the walk
// comes to no face twice.
#pragma once

#include <cstdint>
#include <optional>

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/convex_polyhedron.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb {

/// `interior`: strictly inside a solid, which has no nearest feature.
enum class FeatureKind : unsigned char { vertex, edge, face, interior };

/// Counted from 0 among those of its kind; the interior has number 0.
struct Feature {
  FeatureKind kind;
  std::uint32_t index;
  friend constexpr bool operator==(const Feature&, const Feature&) = default;
};

/// Vertices a, b; the edge.
Feature voronoi_region(const Segment2& segment, const Point2& p);
Feature voronoi_region(const Segment3& segment, const Point3& p);

/// Vertices a, b, c; edges ab, bc, ca; the face, also where p is in it.
Feature voronoi_region(const Triangle2& triangle, const Point2& p);
Feature voronoi_region(const Triangle3& triangle, const Point3& p);

/// Vertices a, b, c, d; edges ab, ac, ad, bc, bd, cd; the faces opposite to a, b, c, d.
Feature voronoi_region(const Tetrahedron3& tetrahedron, const Point3& p);

/// Bit i of a vertex's number says that it is at the upper end of axis i.  An edge's is 4 times its axis, plus 1 and 2
/// where it is at the upper end of the other two axes, x before y before z.  A face's is twice its axis, plus 1 at the
/// upper end.
Feature voronoi_region(const Aabb3& box, const Point3& p);
/// The same along the box's own axes, orthonormal or not.
Feature voronoi_region(const Obb3& box, const Point3& p);

/// Vertices and faces as the mesh numbers them; an edge has the number of the corner that it leaves, the lower of its
/// two.  The walk begins at `start`, such as the answer for a point near to p, and comes nearer with each step.
Feature voronoi_region(const ConvexPolyhedron3& polyhedron, const Point3& p, std::optional<Feature> start = {});

}  // namespace plumb
