// Which shells that are not closed divide a solid that their neighbors at edges of more than two triangles enclose?
//
// The sides of triangles are joined around edges into cells, the parts of space that a surface divides: at an edge of
// one triangle its two sides, at others the sides that face one another between two triangles that follow in their order
// around the edge.  Of the cells of a connected surface one, the outer, has no positive volume.
// Laws: a shell is a wall where no side of its triangles is in the outer cell.  Nothing is said of surfaces with
// triangles on one another at such an edge, or with other than one outer cell: they cross themselves.
// Source: Zhou et al. 2016 (mesh arrangements), 3.3.
// Cost: nothing where no edge of more than two triangles is in a shell that is not closed; else n log n.
#pragma once

#include "plumb/surface/topology/shells.hpp"

namespace plumb::surface {

/// Sets `wall`; shell_of and `closed` are known.
void find_dividing_walls(const TriangleMesh& mesh, const MeshEdges& edges, Shells& found);

}  // namespace plumb::surface
