#include "oracle/cgal_hulls.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <map>

namespace plumb::oracle {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// Do the normals of the facets at the vertex span space?
bool is_extreme(const Mesh& mesh, Mesh::Vertex_index v) {
  std::vector<Kernel::Vector_3> normals;
  for (const auto face : CGAL::faces_around_target(mesh.halfedge(v), mesh)) {
    const auto h = mesh.halfedge(face);
    const auto corner = [&](int k) {
      return mesh.point(mesh.target(k == 0 ? h : k == 1 ? mesh.next(h) : mesh.next(mesh.next(h))));
    };
    normals.push_back(CGAL::normal(corner(0), corner(1), corner(2)));
  }
  for (const auto& a : normals) {
    for (const auto& b : normals) {
      for (const auto& c : normals) {
        if (CGAL::determinant(a, b, c) != 0) return true;
      }
    }
  }
  return false;
}

}  // namespace

std::vector<std::uint32_t> hull_vertices(std::span<const Point3> points) {
  std::vector<Kernel::Point_3> given;
  std::map<Kernel::Point_3, std::uint32_t> number;
  for (const Point3& p : points) {
    given.emplace_back(p.x, p.y, p.z);
    number.emplace(given.back(), static_cast<std::uint32_t>(given.size() - 1));
  }
  Mesh mesh;
  CGAL::convex_hull_3(given.begin(), given.end(), mesh);
  std::vector<std::uint32_t> vertices;
  for (const auto v : mesh.vertices()) {
    if (is_extreme(mesh, v)) vertices.push_back(number.at(mesh.point(v)));
  }
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

}  // namespace plumb::oracle
