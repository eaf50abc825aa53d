// CSG evaluation, boundary evaluation: which mesh bounds what a tree of solids makes, exactly?
//
//   const Csg3 part = (csg(Aabb3{{0, 0, 0}, {4, 4, 4}}) | csg(handle)) - csg(bore);     // handle, bore: TriangleMesh
//   const RoundedMesh rounded = round(evaluate(part));
//
// The tree is that of plumb/figure/containment/csg.hpp; its leaves are closed meshes and flat-sided figures: Aabb3,
// AabbWidths3, AabbCenter3, Obb3, Tetrahedron3, ConvexPolyhedron3.  All are cut along one another once, however deep the
// tree is: so a chain of operations is exact, and rounded at its end.
// Laws: (1) the result bounds the regularized set of the tree; what else it is boolean.hpp says.  (2) A source names the
// leaf by its number in the tree, and of a figure a triangle of its own mesh.  (3) A leaf without interior is empty.
// A leaf that is round or unbounded, or has a corner that is no double, throws InvalidShape, which names it; so does a
// tree whose solid is unbounded, as a complement alone is.  A mesh that is refused by arrange throws what that says.
// Source: RTCD 2.2.1; Requicha and Voelcker 1985 (boundary evaluation).
// Cost: that of arrange for all leaves' triangles together, and a walk of the tree for each region.  Bounded by n^4 signs.
#pragma once

#include "plumb/figure/containment/csg.hpp"
#include "plumb/surface/solid/boolean.hpp"

namespace plumb {

/// A leaf that is the closed mesh's solid: by `positive`, the points around which it winds outward.  Throws as arrange
/// does.  Asked for the place of a point, it builds a tree of boxes once.
Csg3 csg(TriangleMesh mesh);

ExactMesh evaluate(const Csg3& tree, Pieces pieces = Pieces::of_triangles);

}  // namespace plumb
