#include <CGAL/box_intersection_d.h>

#include <vector>

#include "bench/rivals/box_pairs/rival.hpp"

namespace plumb::bench {

std::size_t cgal_box_pairs(std::span<const Aabb3> boxes) {
  using Box = CGAL::Box_intersection_d::Box_d<double, 3>;
  std::vector<Box> all;
  all.reserve(boxes.size());
  for (const auto& [min, max] : boxes) {
    double low[]{min.x, min.y, min.z}, high[]{max.x, max.y, max.z};
    all.emplace_back(low, high);
  }
  std::size_t count = 0;
  CGAL::box_self_intersection_d(all.begin(), all.end(), [&](const Box&, const Box&) { ++count; });
  return count;
}

}  // namespace plumb::bench
