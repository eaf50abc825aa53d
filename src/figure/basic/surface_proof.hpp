// Convexity proof: is a surface of polygons the boundary of a convex solid?  The proof, and the adjacency that it
// finds.
//
// Laws: those of convexity(PolygonMesh) (figure/basic/convexity.hpp).
// Source: Mehlhorn et al. 1999.
// Cost: O(n log n), by sorting edges; some ten exact signs an edge.
#pragma once

#include <vector>

#include "plumb/figure/basic/convexity.hpp"

namespace plumb {

/// Of a mesh whose indices are in range and whose vertices are finite.  Where there is no flaw, `across` (if given)
/// gets the face beyond the edge that leaves each corner.
SurfaceConvexity prove_convex(const PolygonMesh& mesh, std::vector<std::uint32_t>* across = nullptr);

}  // namespace plumb
