// Which vertices are on edges, or run by them?  For edges that are few among many vertices.
//
// Laws: exactly on, strictly between the ends; or within a length of the edge, where the foot of the perpendicular is
// strictly between them.
// Source: RTCD 12.3.
// Cost: a range search in a k-d tree for each edge.
#pragma once

#include <span>

#include "plumb/space/kd_tree/kd_tree.hpp"
#include "surface/repair/divide_edges.hpp"

namespace plumb::surface {

/// Some vertices of a mesh, to be searched.
class SoughtVertices {
 public:
  SoughtVertices(const TriangleMesh& mesh, std::span<const std::uint8_t> among, Execution execution);

  /// Adds a division for each of the vertices that are on the edge, or within the length of it where it is not 0.
  void near_edge(const std::array<std::uint32_t, 2>& edge, double length, std::vector<EdgeDivision>& out) const;

 private:
  const TriangleMesh& mesh_;
  std::vector<std::uint32_t> vertex_;
  KdTree3 tree_;
  mutable std::vector<std::uint32_t> found_;
};

}  // namespace plumb::surface
