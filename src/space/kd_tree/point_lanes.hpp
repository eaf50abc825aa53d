// Branch and bound over the points of a k-d tree, in lanes of doubles: which leaves may hold what is near enough, and
// the values of their points.
//
// Law: of points that are all equal below a node one is looked at, for all.
// Source: Arya and Mount 1993 (incremental distances).
// Cost: a step down for each level, the cells beyond planes that are nearer than what is found.
// Included once for each instruction set (foreach_target.h); hence no #pragma once.
#if defined(PLUMB_POINT_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_POINT_LANES
#undef PLUMB_POINT_LANES
#else
#define PLUMB_POINT_LANES
#endif

#include <hwy/highway.h>

#include <array>
#include <limits>
#include <span>

#include "certify/many_lanes.hpp"
#include "space/kd_tree/point_search.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::space::kd::HWY_NAMESPACE {
namespace {

namespace lanes = certify::many_lanes::HWY_NAMESPACE;
namespace hn = hwy::HWY_NAMESPACE;
using lanes::Many, lanes::Truth, lanes::Lanes, lanes::of_all, lanes::at_most;

constexpr std::size_t count_of_lanes = hn::MaxLanes(Lanes());
constexpr double infinity = std::numeric_limits<double>::infinity();

HWY_INLINE Many load(const double* at) { return {hn::LoadU(Lanes(), at)}; }

/// The first n lanes.
HWY_INLINE unsigned first_lanes(std::size_t n) {
  return n < count_of_lanes ? (1u << n) - 1 : (1u << count_of_lanes) - 1;
}

/// Leaves that are looked at together: one, or all below a node whose points are equal.
struct LeafRun {
  std::size_t leaf, leaves;
};

/// The query, and the tree that it is asked of.
template <class Point>
struct Query {
  static constexpr std::size_t d = KdTree<Point>::dimension;
  const KdTree<Point>& tree;
  const Point& p;
  std::array<double, d> at;
  std::array<double, d> scaled;  // times powers.before
  Powers powers;

  HWY_INLINE Query(const KdTree<Point>& t, const Point& q, Powers times)
      : tree(t), p(q), at(coordinates(q)), scaled(at), powers(times) {
    for (double& x : scaled) x *= powers.before;
  }

  /// The points of a leaf in turn, lane by lane: their values.
  template <class Visit>
  HWY_INLINE void each_value(std::size_t leaf, const Visit& visit) const {
    const std::size_t first = tree.first(leaf), count = tree.first(leaf + 1) - first;
    const double* const from = tree.coordinates.data() + d * first;
    for (std::size_t i = 0; i < count; i += count_of_lanes) {
      const auto square = [&](std::size_t a) HWY_ATTR {
        const Many x = (load(from + a * count + i) * of_all(powers.before) - of_all(scaled[a])) * of_all(powers.after);
        return x * x;
      };
      Many sum = square(0) + square(1);
      if constexpr (d == 3) sum = sum + square(2);
      visit(sum, first, i, count);
    }
  }
  HWY_INLINE Candidate<Point> candidate(std::size_t first, std::size_t i, std::size_t count, double value) const {
    const double* const from = tree.coordinates.data() + d * first + i;
    if constexpr (d == 2) {
      return {{from[0], from[count]}, tree.numbers[first + i], value};
    } else {
      return {{from[0], from[count], from[2 * count]}, tree.numbers[first + i], value};
    }
  }
  /// The numbers of the equal points of a run of leaves, ascending.
  HWY_INLINE std::span<const std::uint32_t> numbers_of(LeafRun run) const {
    const std::size_t first = tree.first(run.leaf);
    return {tree.numbers.data() + first, tree.first(run.leaf + run.leaves) - first};
  }
  /// The first of them, for all.
  HWY_INLINE Candidate<Point> one_of(LeafRun run) const {
    while (tree.first(run.leaf) == tree.first(run.leaf + 1)) ++run.leaf;  // a leaf may be empty, and not all are
    const std::size_t first = tree.first(run.leaf), count = tree.first(run.leaf + 1) - first;
    std::array<double, d> square{};
    for (std::size_t a = 0; a < d; ++a) {
      const double x = (tree.coordinates[d * first + a * count] * powers.before - scaled[a]) * powers.after;
      square[a] = x * x;
    }
    return candidate(first, 0, count, sum_of(square));
  }
  /// The square of the way to a plane; of those to planes of all axes.
  HWY_INLINE double square_to(std::size_t node) const {
    const double x = (scaled[tree.axes[node]] - tree.planes[node] * powers.before) * powers.after;
    return x * x;
  }
  static HWY_INLINE double sum_of(const std::array<double, d>& square) {
    if constexpr (d == 2) {
      return square[0] + square[1];
    } else {
      return square[0] + square[1] + square[2];
    }
  }
};

/// The child of a node on the query's side.
template <class Point>
HWY_INLINE std::size_t near_child(const KdTree<Point>& tree, std::size_t node,
                                  const std::array<double, KdTree<Point>::dimension>& at) {
  return 2 * node + 1 + static_cast<std::size_t>(at[tree.axes[node]] >= tree.planes[node]);
}

template <class Point>
HWY_INLINE std::size_t find_leaf(const KdTree<Point>& tree, const std::array<double, KdTree<Point>::dimension>& at) {
  std::size_t node = 0;
  for (unsigned level = 0; level < tree.levels; ++level) node = near_child(tree, node, at);
  return node - (tree.leaves() - 1);
}

/// Those below a node.
template <class Point>
HWY_INLINE LeafRun leaves_below(const KdTree<Point>& tree, std::size_t node) {
  const auto level = static_cast<unsigned>(63 - __builtin_clzll(node + 1)), below = tree.levels - level;
  return {(node + 1 - (std::size_t{1} << level)) << below, std::size_t{1} << below};
}

/// The cells below a node, of which `square` is known, nearer ones first; `limit()` may fall with every leaf.
template <class Point, class Limit, class Visit>
void search_below(const Query<Point>& query, std::size_t start, const std::array<double, Query<Point>::d>& square,
                  const Limit& limit, const Visit& visit) {
  struct Entry {
    std::size_t node;
    double sum;
    std::array<double, Query<Point>::d> square;
  };
  const KdTree<Point>& tree = query.tree;
  const std::size_t first_leaf = tree.leaves() - 1;
  std::array<Entry, 34> stack;  // one a level at the most
  std::size_t height = 0;
  stack[height++] = {start, 0, square};
  while (height != 0) {
    const Entry top = stack[--height];
    if (top.sum > limit()) continue;
    std::size_t node = top.node;
    if (node < first_leaf && tree.equal[node] != 0) {
      visit(leaves_below(tree, node));
      continue;
    }
    while (node < first_leaf) {
      const std::size_t near = near_child(tree, node, query.at);
      Entry& far = stack[height];
      far.node = 4 * node + 3 - near;
      far.square = top.square;
      far.square[tree.axes[node]] = query.square_to(node);
      far.sum = Query<Point>::sum_of(far.square);
      height += far.sum > limit() ? 0 : 1;
      node = near;
    }
    visit(LeafRun{node - first_leaf, 1});
  }
}

/// The leaf that holds the query, and what may be as near as the limit of the others, from there upward.
template <class Point, class Limit, class Visit>
HWY_INLINE void search_from(const Query<Point>& query, std::size_t leaf, const Limit& limit, const Visit& visit) {
  visit(LeafRun{leaf, 1});
  for (std::size_t node = leaf + (query.tree.leaves() - 1); node != 0; node = (node - 1) / 2) {
    const std::size_t parent = (node - 1) / 2;
    const double value = query.square_to(parent);
    if (value > limit()) continue;
    std::array<double, Query<Point>::d> square{};
    square[query.tree.axes[parent]] = value;
    search_below(query, 4 * parent + 3 - node, square, limit, visit);
  }
}

}  // namespace
}  // namespace plumb::space::kd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
