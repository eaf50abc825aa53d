#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <vector>

#include "bench/rivals/box_pairs/rival.hpp"

namespace plumb::bench {
namespace {

template <class To>
void boost_pairs(std::span<const Aabb3> boxes, To& to) {
  namespace bg = boost::geometry;
  using Point = bg::model::point<double, 3, bg::cs::cartesian>;
  using Value = std::pair<bg::model::box<Point>, std::size_t>;
  std::vector<Value> all;
  for (const auto& [min, max] : boxes)
    all.emplace_back(bg::model::box<Point>({min.x, min.y, min.z}, {max.x, max.y, max.z}), all.size());
  const bg::index::rtree<Value, bg::index::quadratic<16>> tree(all);
  for (const Value& v : all) {
    for (auto at = tree.qbegin(bg::index::intersects(v.first)); at != tree.qend(); ++at) {
      if (at->second > v.second) to(v.second, at->second);
    }
  }
}

}  // namespace

std::size_t boost_box_pairs(std::span<const Aabb3> boxes) {
  PairCount to;
  boost_pairs(boxes, to);
  return to.count;
}
ToldPairs boost_told_pairs(std::span<const Aabb3> boxes) {
  PairKeeper to;
  boost_pairs(boxes, to);
  return std::move(to.pairs);
}

}  // namespace plumb::bench
