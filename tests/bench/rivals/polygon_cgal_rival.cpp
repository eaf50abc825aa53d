#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>

#include <vector>

#include "bench/rivals/polygon_rival.hpp"

namespace plumb::bench {

std::function<long()> cgal_bounded_side(const Polygon2& polygon, std::span<const Point2> points) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto taken = [](std::span<const Point2> from) {
    std::vector<Kernel::Point_2> to;
    for (const Point2& p : from) to.emplace_back(p.x, p.y);
    return to;
  };
  return [chain = taken(polygon.vertices), at = taken(points)] {
    long sum = 0;
    for (const auto& p : at) sum += CGAL::bounded_side_2(chain.begin(), chain.end(), p, Kernel());
    return sum;
  };
}

}  // namespace plumb::bench
