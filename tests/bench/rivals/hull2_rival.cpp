#include "bench/rivals/hull2_rival.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>

#include <iterator>
#include <vector>

namespace plumb::bench {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

struct CgalPoints2::Held {
  std::vector<Kernel::Point_2> points;
};

CgalPoints2::CgalPoints2(std::span<const Point2> points) {
  auto held = std::make_shared<Held>();
  for (const Point2& p : points) held->points.emplace_back(p.x, p.y);
  held_ = std::move(held);
}

std::size_t CgalPoints2::hull_vertices() const {
  std::vector<Kernel::Point_2> hull;
  CGAL::convex_hull_2(held_->points.begin(), held_->points.end(), std::back_inserter(hull));
  return hull.size();
}

}  // namespace plumb::bench
