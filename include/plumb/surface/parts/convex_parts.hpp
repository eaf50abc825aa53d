// Convex decomposition: of which convex polyhedra does a solid consist?  Exactly: closed meshes with holes, cavities and
// whatever touches, into parts that are convex, apart inside, and together the solid.
//
//   const ConvexParts found = convex_parts(mesh);
//   for (const ConvexPart& part : found.parts) {
//     exact_volume(part.solid);               // rational; the parts' sum is the mesh's
//     if (part.is_exact) use(rounded(part));  // its corners are doubles: a PolygonMesh that is_convex
//   }
//
// A notch is an edge where the solid takes more than half a turn.  Each is cut along the plane of one of its two facets,
// together with all others in that plane; where a plane's section has no notch on it the solid is left whole.
// Laws: (1) parts are convex, with volume; no two have more in common than a piece of their boundaries, and their union
// is the solid.  (2) Each face lies in the plane of a triangle of the mesh; so each corner is one of three such planes,
// held as exact points, and as vertices as given where they are equal to one.  (3) Parts are told as
// query/section/solid.hpp tells solids, and ascend by their corners: the order of the mesh's vertices and triangles
// changes nothing but the numbers of triangles.  (4) For r notches, of c shells that bound the solid from outside, there
// are at most c + r (2 r + 1) parts: a notch is crossed by at most 2 r planes, and each piece of it adds one.
// (Cavities in several boxes at once, and shells that touch themselves at a point, may add more, never wrongly.)
// A mesh that bounds no solid throws InvalidShape, which names where: an open edge, triangles that run against each
// other, cross or lie on one another, a triangle without area, a shell that is inside out or crosses another.
// A triangle that names no vertex throws InvalidShape, NaN and infinity in one that it names NonFinite.
// Source: RTCD 12.5.3; Chazelle, Convex partitions of polyhedra, 1984; Bajaj and Dey, Convex decomposition of polyhedra
// and robustness, 1992; Bernstein and Fussell, Fast, exact, linear booleans, 2009, for solids held by their planes.
// Cost: for each cut a sign of each vertex and e log e of the edges of what is cut; a part some 100 us.  Bounded by
// n^2 cuts for n notches, of e edges each, on integers as long as the exponents' span.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/figure/basic/mesh.hpp"
#include "plumb/query/section/solid.hpp"

namespace plumb {

struct ConvexPart {
  SolidIntersection3 solid;
  std::vector<std::uint32_t> plane;    // of each face, the first triangle of the mesh that lies in its plane
  std::vector<std::uint32_t> sources;  // triangles of the mesh that a face has a piece of, ascending for each face
  std::vector<std::uint32_t> first_source{0};
  bool is_exact = false;  // its corners are doubles

  /// A face that cuts alone have made has none.
  [[nodiscard]] std::span<const std::uint32_t> sources_of(std::size_t face) const {
    return std::span(sources).subspan(first_source[face], first_source[face + 1] - first_source[face]);
  }
};

struct ConvexParts {
  std::vector<ConvexPart> parts;
  std::uint64_t notches = 0;  // of the mesh; an edge of several such wedges counts for each
  std::uint64_t cuts = 0;     // by planes, each of one connected solid
};

ConvexParts convex_parts(const TriangleMesh& mesh);

/// Its corners rounded to the nearest doubles, its faces as they are.
PolygonMesh rounded(const ConvexPart& part);

}  // namespace plumb
