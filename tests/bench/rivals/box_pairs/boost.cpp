#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <vector>

#include "bench/rivals/box_pairs/rival.hpp"

namespace plumb::bench {

std::size_t boost_box_pairs(std::span<const Aabb3> boxes) {
  namespace bg = boost::geometry;
  using Point = bg::model::point<double, 3, bg::cs::cartesian>;
  using Value = std::pair<bg::model::box<Point>, std::size_t>;
  std::vector<Value> all;
  for (const auto& [min, max] : boxes)
    all.emplace_back(bg::model::box<Point>({min.x, min.y, min.z}, {max.x, max.y, max.z}), all.size());
  const bg::index::rtree<Value, bg::index::quadratic<16>> tree(all);
  std::size_t count = 0;
  for (const Value& v : all) {
    for (auto at = tree.qbegin(bg::index::intersects(v.first)); at != tree.qend(); ++at) count += at->second > v.second;
  }
  return count;
}

}  // namespace plumb::bench
