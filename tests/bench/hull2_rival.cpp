#include "bench/hull2_rival.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>

#include <cstdio>
#include <iterator>
#include <vector>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace plumb::bench {

std::size_t qhull_vertices_2(std::span<const Point2> points) {
  static std::FILE* const nowhere = std::fopen("/dev/null", "w");
  std::vector<coordT> coordinates;
  coordinates.reserve(2 * points.size());
  for (const Point2& p : points) coordinates.insert(coordinates.end(), {p.x, p.y});
  qhT state;
  qh_zero(&state, nowhere);
  char command[] = "qhull ";
  const int failed =
      qh_new_qhull(&state, 2, static_cast<int>(points.size()), coordinates.data(), False, command, nowhere, nowhere);
  const std::size_t count = failed != 0 ? 0 : static_cast<std::size_t>(state.num_vertices);
  int left = 0, total = 0;
  qh_freeqhull(&state, qh_ALL);
  qh_memfreeshort(&state, &left, &total);
  return count;
}

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
