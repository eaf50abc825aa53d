#include "surface/solid/facet_list.hpp"

namespace plumb::surface {

FacetList divide_planes(const FacePool& pool, PointTable& table, const std::vector<PlaneClass>& classes) {
  FacetList list;
  for (const PlaneClass& of : classes) {
    const auto plane = static_cast<std::uint32_t>(list.planes.size());
    list.planes.emplace_back(pool.points_of(of.faces.front()));
    const PlaneView& view = list.planes.back();
    const auto add = [&](const TriangleMesh::Triangle& corners, std::span<const CoveringFace> covers) {
      list.facets.push_back(corners);
      list.plane_of.push_back(plane);
      list.covers.insert(list.covers.end(), covers.begin(), covers.end());
      list.first_cover.push_back(static_cast<std::uint32_t>(list.covers.size()));
    };
    if (of.is_whole()) {
      auto corners = pool.mesh.triangles[of.faces[0]];
      const CoveringFace by{of.faces[0], !view.is_seen_from_above()};
      if (by.opposite) std::swap(corners[1], corners[2]);
      add(corners, {&by, 1});
    } else {
      for (const PlanePiece& piece : divide_plane(pool, table, of, view)) add(piece.corners, piece.covers);
    }
  }
  return list;
}

}  // namespace plumb::surface
