// Of which triangles do some closed meshes consist, each counted once?  What cancels is gone before any geometry.
//
// Laws: (1) vertices ascend lexicographically, no two equal, and no zero has a sign, first those that doubles hold, then
// the others; a face names its vertices ascending, and faces ascend.  (2) The uses of a face are the triangles with its three points, and whether each turns
// as the face does; they ascend.  A face whose uses cancel for each mesh is left out, unless a sheet uses it, and one
// without area.  So
// vertices and faces do not depend on the order of what was given.
// Source: RTCD 12.1; Zhou et al. 2016.
// Cost: n log n.
#pragma once

#include <span>
#include <vector>

#include "plumb/surface/solid/arrangement.hpp"
#include "surface/solid/numbered_points.hpp"

namespace plumb::surface {

struct FacePool {
  std::uint32_t meshes = 0, sheets = 0;  // the last meshes are sheets, which wind around nothing
  TriangleMesh mesh;              // the faces, each once; vertices that no doubles hold are at their nearest doubles
  std::vector<ExactPoint3> held;  // those, the last ones of the mesh
  std::vector<FacetSource> uses;  // of face f: uses[first_use[f]] up to uses[first_use[f + 1]]
  std::vector<std::uint32_t> first_use{0};

  [[nodiscard]] bool is_sheet(std::uint32_t number) const { return number >= meshes - sheets; }
  [[nodiscard]] NumberedPoints points() const {
    return {std::span(mesh.vertices).first(mesh.vertices.size() - held.size()), held};
  }
  /// All of them doubles.
  [[nodiscard]] std::array<Point3, 3> points_of(std::uint32_t face) const {
    const auto& [a, b, c] = mesh.triangles[face];
    return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
  }
  [[nodiscard]] std::span<const FacetSource> uses_of(std::uint32_t face) const {
    return std::span(uses).subspan(first_use[face], first_use[face + 1] - first_use[face]);
  }
};

/// Throws as arrange does.
FacePool pool_faces(std::span<const TriangleMesh> meshes);
FacePool pool_faces(std::span<const ExactMesh* const> meshes);
/// The last meshes, so many, are sheets.
FacePool pool_faces(std::span<const TriangleMesh* const> meshes, std::uint32_t sheets = 0);
/// The same of pieces of surfaces, which need not be closed.
FacePool pool_open_faces(std::span<const TriangleMesh> meshes);

struct PooledTriangle {
  TriangleMesh::Triangle corners;  // ascending
  FacetSource source;
};

/// Adds what is left of these to a pool of vertices alone.
void add_faces(FacePool& pool, std::vector<PooledTriangle> triangles);

}  // namespace plumb::surface
