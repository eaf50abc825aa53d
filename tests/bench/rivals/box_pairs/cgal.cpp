#include <CGAL/box_intersection_d.h>

#include <vector>

#include "bench/rivals/box_pairs/rival.hpp"

namespace plumb::bench {
namespace {

template <class To>
void cgal_pairs(std::span<const Aabb3> boxes, To& to) {
  using Box = CGAL::Box_intersection_d::Box_d<double, 3>;
  std::vector<Box> all;
  all.reserve(boxes.size());
  for (const auto& [min, max] : boxes) {
    double low[]{min.x, min.y, min.z}, high[]{max.x, max.y, max.z};
    all.emplace_back(low, high);
  }
  if (all.empty()) return;
  const std::size_t first = all.front().id();
  CGAL::box_self_intersection_d(all.begin(), all.end(),
                                [&](const Box& a, const Box& b) { to(a.id() - first, b.id() - first); });
}

}  // namespace

std::size_t cgal_box_pairs(std::span<const Aabb3> boxes) {
  PairCount to;
  cgal_pairs(boxes, to);
  return to.count;
}
ToldPairs cgal_told_pairs(std::span<const Aabb3> boxes) {
  PairKeeper to;
  cgal_pairs(boxes, to);
  return std::move(to.pairs);
}

}  // namespace plumb::bench
