// CGAL's smallest oriented box.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/optimal_bounding_box.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "bench/rivals/obb_rival.hpp"

namespace plumb::bench {

double cgal_box_volume(std::span<const Point3> points) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> all;
  all.reserve(points.size());
  for (const Point3& p : points) all.emplace_back(p.x, p.y, p.z);
  std::array<Kernel::Point_3, 8> corner;
  CGAL::oriented_bounding_box(all, corner, CGAL::parameters::use_convex_hull(true));
  double volume = 1;
  for (const std::size_t i : {std::size_t{1}, std::size_t{3}, std::size_t{5}}) {
    const Kernel::Vector_3 edge = corner[i] - corner[0];
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const Kernel::Point_3& p : all) {
      const double along = edge * (p - CGAL::ORIGIN);
      least = std::min(least, along);
      most = std::max(most, along);
    }
    volume *= (most - least) / std::sqrt(edge.squared_length());
  }
  return volume;
}

}  // namespace plumb::bench
