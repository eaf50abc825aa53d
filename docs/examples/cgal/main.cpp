// A CGAL algorithm on our signs: a Delaunay triangulation of points that are cocircular by the dozen.
//
// plumb::CgalKernel stands where a program names CGAL's Epick; what comes out is the same.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstdio>
#include <plumb/certify/cgal_kernel.hpp>
#include <vector>

namespace {

template <class Kernel>
CGAL::Delaunay_triangulation_2<Kernel> triangulate(int side, double scale) {
  std::vector<typename Kernel::Point_2> points;
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) points.emplace_back(scale * x, scale * y);
  }
  return CGAL::Delaunay_triangulation_2<Kernel>(points.begin(), points.end());
}

}  // namespace

int main() {
  for (const double scale : {1.0, 0.1, 0x1p-200}) {
    const auto ours = triangulate<plumb::CgalKernel>(40, scale);
    const auto theirs = triangulate<CGAL::Exact_predicates_inexact_constructions_kernel>(40, scale);
    bool same = ours.number_of_faces() == theirs.number_of_faces();
    auto face = theirs.finite_faces_begin();
    for (auto f = ours.finite_faces_begin(); same && f != ours.finite_faces_end(); ++f, ++face) {
      for (int k = 0; k < 3; ++k) {
        const auto& p = f->vertex(k)->point();
        const auto& q = face->vertex(k)->point();
        same = same && p.x() == q.x() && p.y() == q.y();
      }
    }
    std::printf("step %g: %zu vertices, %zu triangles, valid: %d, as Epick's: %d\n", scale, ours.number_of_vertices(),
                ours.number_of_faces(), ours.is_valid(), same);
  }
}
