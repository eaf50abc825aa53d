#include "surface/solid/facet_list.hpp"

namespace plumb::surface {

FacetList divide_planes(const FacePool& pool, PointTable& table, const PlaneClasses& classes) {
  FacetList list;
  const auto add = [&](const TriangleMesh::Triangle& corners, std::uint32_t plane,
                       std::span<const CoveringFace> covers) {
    list.facets.push_back(corners);
    list.plane_of.push_back(plane);
    list.covers.insert(list.covers.end(), covers.begin(), covers.end());
    list.first_cover.push_back(static_cast<std::uint32_t>(list.covers.size()));
  };
  list.facets.reserve(pool.mesh.triangles.size());
  list.plane_of.reserve(pool.mesh.triangles.size());
  list.covers.reserve(pool.mesh.triangles.size());
  list.first_cover.reserve(pool.mesh.triangles.size() + 1);
  for (const std::uint32_t face : classes.whole) {
    const CoveringFace by{face, false};
    add(pool.mesh.triangles[face], none, {&by, 1});
  }
  for (const PlaneClass& of : classes.cut) {
    const PlaneView view(pool.points(), pool.mesh.triangles[of.faces.front()]);
    const auto plane = static_cast<std::uint32_t>(list.planes.size());
    list.planes.push_back(view.plane());
    const PlanePieces divided = divide_plane(pool, table, of, view);
    for (const PlanePiece& piece : divided.pieces) add(piece.corners, plane, piece.covers);
  }
  return list;
}

}  // namespace plumb::surface
