// Coplanar faces: which neighboring triangles lie in one plane, and which polygons with holes do they make up?
//
//   const CoplanarFaces faces = merge_coplanar(mesh);                 // exactly, or {.tolerance = 1e-3}
//   for (std::uint32_t f = 0; f < faces.size(); ++f)
//     for (const auto ring : faces.rings_of(f)) print(ring);          // the outer ring first, then the holes
//   const TriangleMesh fewer = triangulated(mesh, faces);
//
// Laws: (1) every triangle is in one face.  Triangles are neighbors over an edge of exactly two that run along it in
// opposite directions; other edges, and vertices alone, join nothing.  A face grows from the triangle `plane` to
// neighbors that turn as it does, seen along an axis, and whose corners are within the tolerance of its plane, compared
// exactly: with tolerance 0 it is all that is reached in that plane.  Else the large ones grow first, as far as doubles
// tell (a guess, which hangs on the points alone).  (2) Rings run as the triangles do, so holes run the other way around.
// They cross nowhere, and wind once around what the triangles cover; triangles that cover one another in the plane, have
// two vertices at one place, a vertex on an edge of a ring, or one in their midst that triangles of other faces have,
// become no polygon: each is a face of its own, and the first is in `apart`.  A ring that passes a vertex twice touches
// itself there; a ring of two corners is both sides of one edge, of more than two triangles.  (3) A vertex is dropped, if
// asked, where all rings that pass it run straight through it, exactly, between the same two neighbors; so all faces
// agree, and no T-junction comes of it.  A triangle of exactly no area is a face of its own and keeps its corners.  (4)
// triangulated() makes of a face its constrained Delaunay triangulation, seen along that axis: n + 2 h - 2 triangles for
// n corners and h holes, the fewest without new vertices.  Faces that would not have fewer stay bit for bit.  Of two
// meshes that differ in the order of vertices and triangles, none of whose points are equal, the same comes.
// A tolerance that is NaN or infinite throws NonFinite, a negative one InvalidShape; so do meshes that are none.
// Source: RTCD 12.4, 12.5.1.
// Cost: linear in the triangles, n log n expected for the corners of faces of three triangles and more, and to sort all
// triangles where there is a tolerance.  Bounded by n^2 signs.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/figure/basic/mesh.hpp"

namespace plumb {

enum class CollinearVertices : unsigned char { kept, dropped };

struct CoplanarOptions {
  double tolerance = 0;
  CollinearVertices collinear = CollinearVertices::kept;
};

/// The rings of face f are numbers first_ring[f] up to first_ring[f + 1]; the vertices of ring r are
/// corners[first_corner[r]] up to corners[first_corner[r + 1]]; the triangles of face f are triangles[first_triangle[f]]
/// up to triangles[first_triangle[f + 1]], ascending.
struct CoplanarFaces {
  std::vector<std::uint32_t> corners, first_corner{0}, first_ring{0};
  std::vector<std::uint32_t> triangles, first_triangle{0};
  std::vector<std::uint32_t> plane;  // of each face the triangle in whose plane it is
  std::vector<std::uint32_t> apart;  // first triangles of those that become no polygon

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(plane.size()); }
  [[nodiscard]] std::vector<std::span<const std::uint32_t>> rings_of(std::uint32_t face) const {
    std::vector<std::span<const std::uint32_t>> rings;
    for (std::uint32_t r = first_ring[face]; r < first_ring[face + 1]; ++r)
      rings.push_back(std::span(corners).subspan(first_corner[r], first_corner[r + 1] - first_corner[r]));
    return rings;
  }
  /// n + 2 h - 2, without new vertices.
  [[nodiscard]] std::uint32_t fewest_triangles(std::uint32_t face) const {
    const std::uint32_t holes = first_ring[face + 1] - first_ring[face] - 1;
    return first_corner[first_ring[face + 1]] - first_corner[first_ring[face]] + 2 * holes - 2;
  }
  [[nodiscard]] std::span<const std::uint32_t> triangles_of(std::uint32_t face) const {
    return std::span(triangles).subspan(first_triangle[face], first_triangle[face + 1] - first_triangle[face]);
  }
};

/// Faces ascend by their first triangles.
CoplanarFaces merge_coplanar(const TriangleMesh& mesh, const CoplanarOptions& options = {});

/// The faces are those of the mesh.  All vertices stay, used or not; new triangles stand in the place of a face's first.
TriangleMesh triangulated(const TriangleMesh& mesh, const CoplanarFaces& faces);

}  // namespace plumb
