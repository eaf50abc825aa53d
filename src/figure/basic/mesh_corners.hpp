// Half-edges: which corner is next to a corner of a convex polyhedron's mesh, and which on the other side of its edge?
//
// Laws: a corner of a face is also the edge that leaves it, as the face runs.  A corner off the line of an edge is
// there, for faces have area.
// Source: RTCD 12.2; figure/basic/convex_polyhedron.hpp.
// Cost: the face of a corner is found by halving; the twin among the corners of one face.
#pragma once

#include <algorithm>

#include "plumb/certify/direction.hpp"
#include "plumb/figure/basic/convex_polyhedron.hpp"

namespace plumb {

class MeshCorners {
 public:
  explicit MeshCorners(const ConvexPolyhedron3& polyhedron) : mesh_corners_(&polyhedron) {}

  [[nodiscard]] const PolygonMesh& mesh() const { return mesh_corners_->mesh; }
  [[nodiscard]] const Point3& at(std::uint32_t corner) const { return mesh().vertices[mesh().corners[corner]]; }
  [[nodiscard]] std::uint32_t face_of(std::uint32_t corner) const {
    return static_cast<std::uint32_t>(std::ranges::upper_bound(mesh().first, corner) - mesh().first.begin() - 1);
  }
  [[nodiscard]] std::uint32_t next(std::uint32_t corner, std::uint32_t face) const {
    return corner + 1 == mesh().first[face + 1] ? mesh().first[face] : corner + 1;
  }
  [[nodiscard]] std::uint32_t next(std::uint32_t corner) const { return next(corner, face_of(corner)); }
  [[nodiscard]] std::uint32_t before(std::uint32_t corner, std::uint32_t face) const {
    return corner == mesh().first[face] ? mesh().first[face + 1] - 1 : corner - 1;
  }
  /// The corner that the same edge leaves on its other side.
  [[nodiscard]] std::uint32_t twin(std::uint32_t corner) const {
    const std::uint32_t face = mesh_corners_->across[corner], head = mesh().corners[next(corner)];
    std::uint32_t c = mesh().first[face];
    while (mesh().corners[c] != head || mesh().corners[next(c, face)] != mesh().corners[corner]) ++c;
    return c;
  }
  /// A corner of the face off the line of its edge: corners may lie on straight edges.
  [[nodiscard]] std::uint32_t corner_off_line(std::uint32_t corner, std::uint32_t face) const {
    const std::uint32_t head = next(corner, face);
    std::uint32_t c = next(head, face);
    if (mesh().first[face + 1] - mesh().first[face] == 3) return c;
    while (c != corner && collinear(at(corner), at(head), at(c))) c = next(c, face);
    return c;
  }
  [[nodiscard]] const Point3& off_line(std::uint32_t corner, std::uint32_t face) const {
    return at(corner_off_line(corner, face));
  }
  /// Does the face's boundary run straight on at this corner?
  [[nodiscard]] bool is_straight(std::uint32_t corner, std::uint32_t face) const {
    if (mesh().first[face + 1] - mesh().first[face] == 3) return false;
    return collinear(at(before(corner, face)), at(corner), at(next(corner, face)));
  }

 private:
  const ConvexPolyhedron3* mesh_corners_;
};

}  // namespace plumb
