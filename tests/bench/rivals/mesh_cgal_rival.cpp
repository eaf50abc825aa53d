#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <vector>

#include "bench/rivals/mesh_rival.hpp"

namespace plumb::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;

Kernel::Point_3 of(const Point3& p) { return {p.x, p.y, p.z}; }
Triangles triangles_of(const TriangleMesh& mesh) {
  Triangles triangles;
  for (const auto& [a, b, c] : mesh.triangles) {
    triangles.emplace_back(of(mesh.vertices[a]), of(mesh.vertices[b]), of(mesh.vertices[c]));
  }
  return triangles;
}

}  // namespace

struct CgalMesh::Tree {
  Triangles triangles;
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree;
};

CgalMesh::CgalMesh(const TriangleMesh& mesh) : tree_(std::make_unique<Tree>()) {
  tree_->triangles = triangles_of(mesh);
  tree_->tree.insert(tree_->triangles.cbegin(), tree_->triangles.cend());
  tree_->tree.build();
  tree_->tree.accelerate_distance_queries();
}
CgalMesh::~CgalMesh() = default;

std::size_t CgalMesh::pairs_with(const TriangleMesh& mesh) const {
  std::size_t pairs = 0;
  for (const Kernel::Triangle_3& t : triangles_of(mesh)) pairs += tree_->tree.number_of_intersected_primitives(t);
  return pairs;
}

std::size_t CgalMesh::meeting(const CgalMesh& other, std::span<const std::array<unsigned, 2>> pairs) const {
  std::size_t n = 0;
  for (const auto& [i, k] : pairs) {
    n += CGAL::do_intersect(tree_->triangles[i], other.tree_->triangles[k]) ? 1 : 0;
  }
  return n;
}

double CgalMesh::squared_distances(std::span<const Point3> points) const {
  double sum = 0;
  for (const Point3& p : points) sum += tree_->tree.squared_distance(of(p));
  return sum;
}

}  // namespace plumb::bench
