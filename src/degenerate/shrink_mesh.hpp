// What is the simplest mesh that still fails?  Fewer triangles, then fewer points.
//
// Triangles are lost in blocks, halves first, then one by one.  A surface stays closed: the hole that a block leaves is
// closed again by a fan from one of its corners, an edge is collapsed by moving all points of a place to another one,
// triangles of which one covers the other are lost together.  Then equal points become one, and points that no triangle
// names are lost.
// Laws: (1) every mesh tried has fewer triangles than the last one taken, or as many and fewer points in use, or fewer
// points; so it ends.  (2) Of a closed mesh every mesh tried is closed.
// Source: Zeller and Hildebrandt, "Simplifying and isolating failure-inducing input" (delta debugging); edges collapse
// as in Hoppe et al., "Mesh optimization".
// Cost: n log n calls for n triangles, as many again as edges collapse.
#pragma once

#include <functional>

#include "degenerate/mesh_case.hpp"

namespace plumb::degenerate {

/// `attempt` says whether the mesh still fails; if so, the next ones are made of it.
void shrink_mesh(MeshCase mesh, bool closed, const std::function<bool(const MeshCase&)>& attempt);

}  // namespace plumb::degenerate
