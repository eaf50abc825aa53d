#include "bench/hull_rival.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <cstdio>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace plumb::bench {

std::size_t qhull_vertices(std::span<const Point3> points) {
  static std::FILE* const nowhere = std::fopen("/dev/null", "w");
  std::vector<coordT> coordinates;
  coordinates.reserve(3 * points.size());
  for (const Point3& p : points) coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
  qhT state;
  qh_zero(&state, nowhere);
  char command[] = "qhull ";
  const int failed =
      qh_new_qhull(&state, 3, static_cast<int>(points.size()), coordinates.data(), False, command, nowhere, nowhere);
  const std::size_t count = failed != 0 ? 0 : static_cast<std::size_t>(state.num_vertices);
  int left = 0, total = 0;
  qh_freeqhull(&state, qh_ALL);
  qh_memfreeshort(&state, &left, &total);
  return count;
}

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

struct CgalPoints::Held {
  std::vector<Kernel::Point_3> points;
};

CgalPoints::CgalPoints(std::span<const Point3> points) : held_(new Held) {
  for (const Point3& p : points) held_->points.emplace_back(p.x, p.y, p.z);
}

CgalPoints::~CgalPoints() { delete held_; }

std::size_t CgalPoints::hull_vertices() const {
  CGAL::Surface_mesh<Kernel::Point_3> mesh;
  CGAL::convex_hull_3(held_->points.begin(), held_->points.end(), mesh);
  return mesh.number_of_vertices();
}

}  // namespace plumb::bench
