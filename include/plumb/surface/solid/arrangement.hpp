// Arrangement: into which facets and cells do closed meshes and sheets cut space, and how often does each wind around each cell?
//
//   const std::vector<TriangleMesh> meshes{a, b};
//   const Arrangement all = arrange(meshes);
//   for (std::size_t f = 0; f < all.facets.size(); ++f)
//     use(all.facets[f], all.windings_of(all.sides[f].above), all.windings_of(all.sides[f].below));
//
// A mesh may touch and cross itself, hold several shells and voids, triangles twice, against one another or without
// area, and vertices more than once: points that are equal are one.
// Laws: (1) the facets cover what the meshes' triangles cover, but for triangles that cancel one another; two have
// nothing in common but vertices and edges that both have.  A facet is seen counterclockwise from above.  (2) A facet
// that is a whole triangle has its vertices as given.  (3) Every sign is that of the exact points; a winding number is
// that of plumb/space/ray/inside.hpp.  (4) A region is one side of facets that are connected around edges: it lies in
// one cell, and a cell that has others in it has several.  (5) Facets, vertices and their order depend on the points
// and the triangles' directions alone, not on the order of meshes, vertices or triangles, nor on threads; so do
// regions, but for the order of the numbers in their windings.
// (6) `of_polygons`: neighbors over an edge of two triangles of a mesh that lie in one plane, decided exactly, are one
// polygon, and no edge in its midst cuts anything.  Windings are the same; a facet's source is then the least triangle of
// its polygon, once for each time that the mesh winds around it; of laws 1 and 2 what triangles have alone is not kept.
// (7) An exact mesh is taken as a mesh of doubles is: the same points and triangles make the same arrangement.
// (8) Sheets need not be closed: they are cut and cut others, and wind around nothing.  Both sides of a sheet's triangles
// count: what a sheet has twice, or turned both ways, is not canceled.
// A mesh that is not closed, or whose triangles run against each other, throws UnbalancedEdge, which names an edge and a
// triangle there; a triangle that names no vertex throws InvalidShape.  NaN and infinity throw NonFinite, an exact point
// whose nearest doubles are infinite BeyondDoubles.
// Source: RTCD 2.2.1; Zhou, Grinspun, Zorin and Jacobson, Mesh arrangements for solid geometry, 2016; Hoffmann 1989.
// Cost: that of a tree and of intersecting_pairs for all triangles together; some 10 us for each pair that meets; n log n
// for each plane's segments and their pieces, and for edges; a descent for each connected group of facets.
// Faces with corners that no doubles hold take some signs for each pair of boxes that overlap, and rationals for each
// point that they make.
// Bounded by n^4 signs, for n triangles may cut one another into n^3 pieces.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "plumb/arith/error.hpp"
#include "plumb/surface/solid/exact_mesh.hpp"

namespace plumb {

/// A facet is a piece of the triangle, which has the same direction or the opposite one.
struct FacetSource {
  SourceFace face;
  bool opposite;
  friend auto operator<=>(const FacetSource&, const FacetSource&) = default;
};

/// Numbers of regions.
struct FacetSides {
  std::uint32_t above, below;
  friend auto operator<=>(const FacetSides&, const FacetSides&) = default;
};

struct Arrangement {
  std::uint32_t meshes = 0;
  std::vector<ExactPoint3> vertices;  // as an ExactMesh has them
  std::vector<TriangleMesh::Triangle> facets;
  std::vector<FacetSides> sides;
  /// Those of facet f are sources[first_source[f]] up to sources[first_source[f + 1]], ascending.
  std::vector<FacetSource> sources;
  std::vector<std::uint32_t> first_source{0};
  /// Mesh m winds around region r so often: windings[r * meshes + m].
  std::vector<std::int32_t> windings;

  [[nodiscard]] std::size_t regions() const { return meshes == 0 ? 0 : windings.size() / meshes; }
  [[nodiscard]] std::span<const FacetSource> sources_of(std::size_t facet) const {
    return std::span(sources).subspan(first_source[facet], first_source[facet + 1] - first_source[facet]);
  }
  [[nodiscard]] std::span<const std::int32_t> windings_of(std::size_t region) const {
    return std::span(windings).subspan(region * meshes, meshes);
  }
};

/// Triangles of a mesh run along an edge more often one way than the other.
struct UnbalancedEdge : InvalidShape {
  UnbalancedEdge(const std::string& text, SourceFace found, const std::array<Point3, 2>& along, bool is_one_open)
      : InvalidShape(text), face(found), edge(along), is_open(is_one_open) {}
  SourceFace face;             // one of them
  std::array<Point3, 2> edge;  // its ends, in lexicographic order; the nearest doubles of an exact mesh's
  bool is_open;                // an odd number of triangles has the edge; else they run against each other
};

/// What is cut: each triangle, or the polygons that neighbors of a mesh make up in one plane?
enum class Pieces : unsigned char { of_triangles, of_polygons };

Arrangement arrange(std::span<const TriangleMesh> meshes, Pieces pieces = Pieces::of_triangles);
/// Sheets are numbered after the solids.
Arrangement arrange(std::span<const TriangleMesh> solids, std::span<const TriangleMesh> sheets);
/// Takes what operations made, or exact_mesh under a pose: nothing is rounded between.
Arrangement arrange(std::span<const ExactMesh> meshes, Pieces pieces = Pieces::of_triangles);

}  // namespace plumb
