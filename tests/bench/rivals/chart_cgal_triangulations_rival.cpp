// CGAL's constrained Delaunay triangulation of a polygon, by its kernel of exact predicates.
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "bench/rivals/chart_rival.hpp"
#include "lab/trial/cutting_round.hpp"

namespace plumb::bench {
namespace {

using lab::trial::Cut;
using lab::trial::CutPolygon;
using lab::trial::EarTriangles;

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Epick>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<int, Epick, CGAL::Constrained_triangulation_face_base_2<Epick>>;
using Data = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Constrained = CGAL::Constrained_Delaunay_triangulation_2<Epick, Data>;

constexpr int not_seen = -1;

/// How many constraints lie between each face and the infinite one, as CGAL's manual counts them.
void count_nesting(Constrained& made) {
  for (const auto face : made.all_face_handles()) face->info() = not_seen;
  std::vector<Constrained::Face_handle> level{made.infinite_face()}, next;
  for (int depth = 0; !level.empty(); ++depth, level = std::move(next), next.clear()) {
    while (!level.empty()) {
      const auto face = level.back();
      level.pop_back();
      if (face->info() != not_seen) continue;
      face->info() = depth;
      for (int k = 0; k < 3; ++k)
        if (face->neighbor(k)->info() == not_seen)
          (face->is_constrained(k) ? next : level).push_back(face->neighbor(k));
    }
  }
}

EarTriangles triangles_of(const std::vector<Epick::Point_2>& corners) {
  Constrained made;
  std::vector<Constrained::Vertex_handle> at;
  for (std::uint32_t i = 0; i < corners.size(); ++i) {
    const std::size_t before = made.number_of_vertices();
    at.push_back(made.insert(corners[i]));
    if (made.number_of_vertices() != before) at.back()->info() = i;
  }
  for (std::size_t i = 0; i < at.size(); ++i)
    if (const auto end = at[(i + 1) % at.size()]; at[i] != end) made.insert_constraint(at[i], end);
  count_nesting(made);
  EarTriangles triangles;
  for (const auto face : made.finite_face_handles())
    if (face->info() % 2 == 1)
      triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  return triangles;
}

}  // namespace

void add_cgal_triangulations(Rivals& all) {
  all.push_back({"triangulation", lab::trial::cutting_method("epick", "CGAL's Constrained_Delaunay_triangulation_2",
                                                             [](const CutPolygon& polygon) -> Cut {
                                                               std::vector<Epick::Point_2> corners;
                                                               for (std::size_t i = 0; i < polygon.size(); i += 2)
                                                                 corners.emplace_back(polygon[i], polygon[i + 1]);
                                                               return [corners] { return triangles_of(corners); };
                                                             })});
}

}  // namespace plumb::bench
