#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>

#include <exception>

#include "bench/rivals/solid/rival.hpp"

namespace plumb::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

Surface surface_of(const TriangleMesh& mesh) {
  Surface s;
  s.reserve(static_cast<unsigned>(mesh.vertices.size()), static_cast<unsigned>(mesh.triangles.size() * 3 / 2),
            static_cast<unsigned>(mesh.triangles.size()));
  for (const Point3& p : mesh.vertices) s.add_vertex({p.x, p.y, p.z});
  using Vertex = Surface::Vertex_index;
  for (const auto& [a, b, c] : mesh.triangles) s.add_face(Vertex(a), Vertex(b), Vertex(c));
  return s;
}

}  // namespace

std::optional<std::size_t> unite_by_cgal(const TriangleMesh& a, const TriangleMesh& b) {
  try {
    namespace PMP = CGAL::Polygon_mesh_processing;
    Surface left = surface_of(a), right = surface_of(b), both;
    if (!PMP::corefine_and_compute_union(left, right, both, PMP::parameters::throw_on_self_intersection(true)))
      return {};
    return both.number_of_faces();
  } catch (const std::exception&) {
    return {};
  }
}

}  // namespace plumb::bench
