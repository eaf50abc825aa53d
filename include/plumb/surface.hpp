// The face of meshes and their files: what is in a file, is it a clean surface, what makes it one, where does a plane cut
// it, and how are solids, polygons, points and segments of a plane divided?
//
// Meshes are plain structs, with whatever a file from the wild has in it (docs/meshes.md).
// Source: docs/sections.md, chapters 2 and 12.
#pragma once

#include "plumb/figure/basic/mesh.hpp"                   // TriangleMesh, PolygonMesh
#include "plumb/surface/file/decimal.hpp"                // which double a decimal is
#include "plumb/surface/file/mesh_file.hpp"              // formats, and MeshFileError
#include "plumb/surface/file/read_assembly.hpp"          // parts of a file by their names
#include "plumb/surface/file/read_mesh.hpp"              // OBJ, OFF, STL, PLY, 3MF, glTF, packed or not
#include "plumb/surface/file/write_mesh.hpp"             // to a file, or to text
#include "plumb/surface/parts/convex_parts.hpp"          // solids into convex ones
#include "plumb/surface/parts/covering_parts.hpp"        // few hulls that cover a solid
#include "plumb/surface/planar/arrange_segments.hpp"     // crossings, edges, faces and windings of segments
#include "plumb/surface/planar/convex_pieces.hpp"        // polygons into convex ones
#include "plumb/surface/planar/delaunay.hpp"             // points and segments into triangles
#include "plumb/surface/planar/planarity.hpp"            // how thick polygons are that are not planar
#include "plumb/surface/planar/triangulate.hpp"          // polygons into triangles
#include "plumb/surface/planar/triangulate_polygon.hpp"  // polygons with holes into triangles
#include "plumb/surface/planar/voronoi.hpp"              // centers of circles, exactly
#include "plumb/surface/repair/merge_coplanar.hpp"       // triangles of one plane into polygons with holes
#include "plumb/surface/repair/repair.hpp"               // mending: holes, T-junctions, double faces, orientation
#include "plumb/surface/repair/weld.hpp"                 // vertices that are one, exactly or within a tolerance
#include "plumb/surface/section/section.hpp"             // contours of one plane or many
#include "plumb/surface/solid/arrangement.hpp"           // facets and cells of closed meshes, with their windings
#include "plumb/surface/solid/boolean.hpp"               // union, intersection, difference, exactly
#include "plumb/surface/solid/evaluate.hpp"              // CSG trees of meshes and flat-sided figures as meshes
#include "plumb/surface/solid/exact_mesh.hpp"            // what these make
#include "plumb/surface/solid/intersection_curves.hpp"   // where two surfaces meet
#include "plumb/surface/solid/merge_pieces.hpp"          // coplanar pieces of what these make, as polygons
#include "plumb/surface/solid/round.hpp"                 // its doubles, sound or not
#include "plumb/surface/solid/split.hpp"                 // its parts on two sides of a plane
#include "plumb/surface/topology/adjacency.hpp"          // half-edges, winged edges, triangles at a vertex
#include "plumb/surface/topology/components.hpp"         // connected components, boundary loops, Euler's formula
#include "plumb/surface/topology/defects.hpp"            // bow ties, T-junctions, double faces, close vertices
#include "plumb/surface/topology/faults.hpp"             // all that is wrong, counted
#include "plumb/surface/topology/shells.hpp"             // components: nesting, which is inside out, volumes
#include "plumb/surface/topology/topology.hpp"           // neighbors, open edges
