#include "bench/rivals/hull_rival.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

namespace plumb::bench {

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
