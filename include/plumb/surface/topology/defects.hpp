// Is this surface a manifold, are its edges matched, and are its vertices and triangles each there once?  What a mesh
// has that mesh software stumbles over: bow ties, T-junctions, double faces, vertices too near to one another.
//
// Laws: (1) a vertex is no manifold where its triangles are several fans, that is: fall apart into groups no two of
// which share an edge at the vertex; vertices are those of their numbers.  Where only an edge of more than two triangles
// is at fault, its ends are not told (RTCD 12.3 counts those edges: topology.hpp).  (2) A vertex is on an edge where
// the point is strictly between the edge's ends; all such pairs are listed, of vertices that a triangle names.  It is
// near one where it is at most the length from it, the foot of the perpendicular is strictly between the ends, and no
// triangle at the edge has the vertex, which would be a sliver.  (3) A
// triangle coincides with the first that has the same three points, whatever their numbers; it is opposite where the
// two turn against each other, else a duplicate.  Triangles of fewer than three points coincide with none.  (4) A vertex
// is close where another point of a vertex is nearer than the length; equal points are no others.  (5) Lists ascend;
// exact, and the same on every number of threads.
// A length that is NaN or infinite throws NonFinite, a negative one InvalidShape.
// Source: RTCD 12.1, 12.3.
// Cost: non_manifold_vertices linear; vertices_on_edges and vertices_near_edges a descent for each vertex; coincident_triangles first_equal,
// and linear but for heaps; close_vertices a k-d tree and a search for each vertex, whatever the length.  Bounded by
// n^2 pairs of vertices, or of a vertex and an edge, on integers as long as the exponents' span.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/space/bvh/bvh.hpp"
#include "plumb/surface/topology/topology.hpp"

namespace plumb {

std::vector<std::uint32_t> non_manifold_vertices(const TriangleMesh& mesh, const MeshEdges& edges);

struct VertexOnEdge {
  std::uint32_t vertex;
  std::uint32_t edge;  // its number in MeshEdges
  friend auto operator<=>(const VertexOnEdge&, const VertexOnEdge&) = default;
};

/// The edges and the tree are those of the mesh.
std::vector<VertexOnEdge> vertices_on_edges(const MeshEdges& edges, const Bvh& bvh,
                                            Execution execution = Execution::parallel);
std::vector<VertexOnEdge> vertices_near_edges(const MeshEdges& edges, const Bvh& bvh, double length,
                                              Execution execution = Execution::parallel);

struct CoincidentTriangle {
  std::uint32_t triangle;
  std::uint32_t first;  // the triangle of smallest number with the same points
  bool opposite;
  friend bool operator==(const CoincidentTriangle&, const CoincidentTriangle&) = default;
};

std::vector<CoincidentTriangle> coincident_triangles(const TriangleMesh& mesh);
/// With first_equal(mesh.vertices), for who has it.
std::vector<CoincidentTriangle> coincident_triangles(const TriangleMesh& mesh, std::span<const std::uint32_t> first);

struct CloseVertex {
  std::uint32_t vertex;   // that a triangle names, the first of its point
  std::uint32_t nearest;  // of the other points' first vertices
  friend bool operator==(const CloseVertex&, const CloseVertex&) = default;
};

std::vector<CloseVertex> close_vertices(const TriangleMesh& mesh, double length,
                                        Execution execution = Execution::parallel);

}  // namespace plumb
