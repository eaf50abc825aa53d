// Meshes asked by CGAL's tree of boxes, over its kernel of exact predicates: which pairs meet, what is nearest to a point.
// And by pairs that another's boxes leave.
#pragma once

#include <array>
#include <memory>
#include <span>

#include "plumb/figure/basic/mesh.hpp"

namespace plumb::bench {

class CgalMesh {
 public:
  explicit CgalMesh(const TriangleMesh& mesh);  // builds the tree for distances, too
  ~CgalMesh();
  CgalMesh(const CgalMesh&) = delete;
  CgalMesh& operator=(const CgalMesh&) = delete;

  /// Pairs of triangles that meet: each of the mesh asked of the tree.
  [[nodiscard]] std::size_t pairs_with(const TriangleMesh& mesh) const;
  /// Of pairs (triangle here, triangle there), how many meet.
  [[nodiscard]] std::size_t meeting(const CgalMesh& other, std::span<const std::array<unsigned, 2>> pairs) const;
  /// The sum of the squares of the distances.
  [[nodiscard]] double squared_distances(std::span<const Point3> points) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace plumb::bench
