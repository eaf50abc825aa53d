#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "oracle/cgal_kernel.hpp"
#include "oracle/triangulations.hpp"

namespace plumb::oracle {

std::vector<std::array<std::uint32_t, 3>> constrained_triangles(
    std::span<const Point2> points, std::span<const std::array<std::uint32_t, 2>> segments) {
  using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
  using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
  using Data = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
  CGAL::Constrained_Delaunay_triangulation_2<Kernel, Data> triangulation;
  std::vector<decltype(triangulation)::Vertex_handle> at;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const std::size_t before = triangulation.number_of_vertices();
    at.push_back(triangulation.insert({Number(points[i].x), Number(points[i].y)}));
    if (triangulation.number_of_vertices() != before) at.back()->info() = i;
  }
  for (const auto& [a, b] : segments)
    if (at[a] != at[b]) triangulation.insert_constraint(at[a], at[b]);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f)
    triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  return triangles;
}

}  // namespace plumb::oracle
