#include "plumb/space/kd_tree/kd_tree.hpp"

#include <array>
#include <limits>
#include <string>

#include "certify/batch/all_threads.hpp"
#include "figure/basic/finite_parts.hpp"
#include "plumb/arith/error.hpp"
#include "space/kd_tree/point_search.hpp"
#include "space/kd_tree/select.hpp"

namespace plumb {
namespace space::kd {
namespace {

template <std::size_t d>
struct NumberedPoint {
  std::array<double, d> at;
  std::uint32_t number;
};

struct Spread {
  std::uint8_t axis;  // in which the points spread widest: a guess, of halves that do not overflow
  bool is_none;       // all are equal
};
template <std::size_t d>
Spread spread_of(const NumberedPoint<d>* first, const NumberedPoint<d>* last) {
  std::array<double, d> least = first->at, most = first->at;
  for (const NumberedPoint<d>* i = first; i != last; ++i) {
    for (std::size_t a = 0; a < d; ++a) {
      least[a] = i->at[a] < least[a] ? i->at[a] : least[a];
      most[a] = i->at[a] > most[a] ? i->at[a] : most[a];
    }
  }
  std::size_t best = 0;
  const auto width = [&](std::size_t a) { return most[a] / 2 - least[a] / 2; };
  for (std::size_t a = 1; a < d; ++a) best = width(a) > width(best) ? a : best;
  return {static_cast<std::uint8_t>(best), least == most};
}

template <class Point>
class Builder {
 public:
  static constexpr std::size_t d = KdTree<Point>::dimension;

  Builder(KdTree<Point>& tree, NumberedPoint<d>* items, Execution execution)
      : tree_(tree), items_(items), execution_(execution) {}

  /// The subtree of a node of this level, the leaves from `leaf` on.
  void build(std::size_t node, unsigned level, std::size_t leaf) {
    const std::size_t leaves = std::size_t{1} << (tree_.levels - level);
    NumberedPoint<d>* const first = items_ + tree_.first(leaf);
    NumberedPoint<d>* const last = items_ + tree_.first(leaf + leaves);
    if (leaves == 1) {
      fill(leaf, first, last);
      return;
    }
    const auto [axis, is_one_place] = first == last ? Spread{0, false} : spread_of(first, last);
    NumberedPoint<d>* const middle = items_ + tree_.first(leaf + leaves / 2);
    if (axis == 0) halve<0>(first, middle, last);
    if (axis == 1) halve<1>(first, middle, last);
    if constexpr (d == 3) {
      if (axis == 2) halve<2>(first, middle, last);
    }
    // Where there is one point, or none, a half is empty.
    tree_.planes[node] = first == last ? 0 : (middle == last ? last[-1] : *middle).at[axis];
    tree_.axes[node] = axis;
    tree_.equal[node] = is_one_place ? 1 : 0;
    constexpr std::ptrdiff_t worth_a_task = 4096;
    const auto lower = [&] { build(2 * node + 1, level + 1, leaf); };
    const auto upper = [&] { build(2 * node + 2, level + 1, leaf + leaves / 2); };
    const bool by_two = execution_ == Execution::parallel && last - first > worth_a_task;
    certify::batch::for_each_part(by_two ? Execution::parallel : Execution::serial, 2,
                                  [&](std::size_t half) { half == 0 ? lower() : upper(); });
  }

 private:
  template <std::size_t axis>
  static void halve(NumberedPoint<d>* first, NumberedPoint<d>* middle, NumberedPoint<d>* last) {
    select(first, middle, last, [](const NumberedPoint<d>& a, const NumberedPoint<d>& b) {
      return static_cast<int>(a.at[axis] < b.at[axis]) |
             (static_cast<int>(a.at[axis] == b.at[axis]) & static_cast<int>(a.number < b.number));
    });
  }
  void fill(std::size_t leaf, NumberedPoint<d>* first, NumberedPoint<d>* last) {
    const auto by_number = [](const NumberedPoint<d>& a, const NumberedPoint<d>& b) { return a.number < b.number; };
    for (NumberedPoint<d>* i = first; i != last; ++i) {  // by insertion: they are few, and often in order
      for (NumberedPoint<d>* k = i; k != first && by_number(k[0], k[-1]); --k) std::swap(k[0], k[-1]);
    }
    const auto count = static_cast<std::size_t>(last - first), start = std::size_t{tree_.first(leaf)};
    double* const to = tree_.coordinates.data() + d * start;
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t a = 0; a < d; ++a) to[a * count + i] = first[i].at[a];
      tree_.numbers[start + i] = first[i].number;
    }
  }

  KdTree<Point>& tree_;
  NumberedPoint<d>* items_;
  Execution execution_;
};

}  // namespace
}  // namespace space::kd

template <KeptPoint Point>
KdTree<Point> build_kd_tree(std::span<const Point> points, const KdTreeOptions& options) {
  using namespace space::kd;
  constexpr std::size_t d = KdTree<Point>::dimension;
  if (points.size() > std::numeric_limits<std::uint32_t>::max())
    throw InvalidShape("build_kd_tree: " + std::to_string(points.size()) +
                       " points, but 2^32 - 1 at most are numbered");
  if (options.most_in_leaf < 1)
    throw InvalidShape("build_kd_tree: options.most_in_leaf is 0, but a leaf holds one point at least");
  KdTree<Point> tree;
  tree.count = static_cast<std::uint32_t>(points.size());
  while ((std::uint64_t{tree.count} + tree.leaves() - 1) >> tree.levels > options.most_in_leaf) ++tree.levels;
  require_finite_points("build_kd_tree", "points", points);
  std::vector<NumberedPoint<d>> items(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    items[i] = {coordinates(points[i]), static_cast<std::uint32_t>(i)};
    for (const double x : items[i].at) tree.halves &= has_half(x);
  }
  tree.planes.resize(tree.leaves() - 1);
  tree.axes.resize(tree.leaves() - 1);
  tree.equal.resize(tree.leaves() - 1);
  tree.numbers.resize(points.size());
  tree.coordinates.resize(d * points.size() + KdTree<Point>::padding);
  if (tree.count != 0) Builder<Point>(tree, items.data(), options.execution).build(0, 0, 0);
  return tree;
}

template <class Point>
std::size_t memory_of(const KdTree<Point>& tree) {
  return sizeof(double) * (tree.planes.capacity() + tree.coordinates.capacity()) + tree.axes.capacity() +
         tree.equal.capacity() + sizeof(std::uint32_t) * tree.numbers.capacity();
}

template KdTree2 build_kd_tree(std::span<const Point2>, const KdTreeOptions&);
template KdTree3 build_kd_tree(std::span<const Point3>, const KdTreeOptions&);
template std::size_t memory_of(const KdTree2&);
template std::size_t memory_of(const KdTree3&);

}  // namespace plumb
