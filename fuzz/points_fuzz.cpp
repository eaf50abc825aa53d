// Are the nearest of some points, those in a ball and those in a box the ones that asking each point tells?  And of
// segments between them?
//
// The bytes are points, how many a leaf holds, and places: of small integers, an ulp off, spread, or as they stand.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "plumb/certify/compare_distance.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "plumb/figure/aabb/relation.hpp"
#include "plumb/figure/containment/contains.hpp"
#include "plumb/query/closest/closest.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/space.hpp"

namespace plumb::fuzz {
namespace {

void expect(bool holds, const char* what) {
  if (holds) return;
  std::cerr << what << std::endl;
  std::abort();
}

double coordinate(Entropy& e, std::uint64_t form) {
  switch (form) {
    case 0:
      return static_cast<double>(e.within(3));
    case 1: {
      const double x = static_cast<double>(e.within(3)) / 4;
      const std::int64_t way = e.within(1);
      return way == 0 ? x : std::nextafter(x, static_cast<double>(way) * std::numeric_limits<double>::infinity());
    }
    case 2:
      return std::ldexp(static_cast<double>(e.within(1000)), static_cast<int>(e.within(40)));
    default:
      break;
  }
  const double x = std::bit_cast<double>(e.bits(64));
  return x - x == 0 ? x : 0;
}
Point3 some_point(Entropy& e, std::uint64_t form) {
  const double x = coordinate(e, form), y = coordinate(e, form), z = coordinate(e, form);
  return {x, y, z};
}

/// Between the doubles beside it, where these are numbers.
bool is_distance(const Point3& p, const Point3& q, double d) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double below = std::nextafter(d, 0.0), above = std::nextafter(d, infinity);
  if (d == 0) return compare_distance(p, q, std::numeric_limits<double>::denorm_min()) == Sign::negative;
  return compare_distance(p, q, below) == Sign::positive &&
         (above == infinity || compare_distance(p, q, above) == Sign::negative);
}

void check(const std::vector<Point3>& points, const KdTree3& tree, const PointOctree& octree, const Point3& p,
           std::size_t k, double radius, const Aabb3& box) {
  std::vector<std::uint32_t> order(points.size()), in_ball, inside;
  std::iota(order.begin(), order.end(), 0U);
  for (const std::uint32_t i : order) {
    if (compare_distance(p, points[i], radius) != Sign::positive) in_ball.push_back(i);
    if (contains(box, points[i])) inside.push_back(i);
  }
  std::ranges::stable_sort(order, [&](std::uint32_t a, std::uint32_t b) {
    return compare_distance(p, points[a], points[b]) == Sign::negative;
  });
  std::size_t with_ties = k;
  while (with_ties < order.size() && compare_distance(p, points[order[k - 1]], points[order[with_ties]]) == Sign::zero)
    ++with_ties;
  const auto expect_first = [&](std::span<const NearestPoint> found, std::size_t n, const char* what) {
    expect(found.size() == n, what);
    for (std::size_t i = 0; i < n; ++i) {
      expect(found[i].index == order[i], what);
      if (std::isfinite(found[i].distance)) expect(is_distance(p, points[order[i]], found[i].distance), "distance");
    }
  };
  const NearestPoint one = nearest(tree, p);
  expect_first({&one, 1}, 1, "nearest");
  expect_first(nearest(tree, p, k), k, "the nearest k");
  expect_first(nearest(tree, p, k, Ties::all), with_ties, "the nearest k with ties");
  std::vector<NearestPoint> batch(2 * k);
  const std::vector<Point3> twice{p, p};
  nearest(tree, twice, k, batch, Execution::serial);
  expect_first(std::span(batch).first(k), k, "the nearest k of a batch");
  expect_first(std::span(batch).last(k), k, "the nearest k of a batch's last");
  expect(within(tree, p, radius) == in_ball, "within");
  expect(in_box(tree, box) == inside, "in_box");
  expect(in_box(octree, box) == inside, "in_box of an octree");
  std::erase_if(inside, [&](std::uint32_t i) { return relate(box, {points[i], points[i]}) != Relation::overlapping; });
  expect(in_box(tree, box, {.touching = false}) == inside, "in_box without touching");
  expect(in_box(octree, box, {.touching = false}) == inside, "in_box of an octree without touching");
}

/// Each between a point and the next.
void check_segments(const std::vector<Point3>& points, std::uint32_t in_leaf, const Point3& p, std::size_t k,
                    double radius, const Aabb3& box) {
  constexpr std::size_t most_segments = 16;
  std::vector<Segment3> all;
  for (std::size_t i = 0; i < std::min(points.size(), most_segments); ++i)
    all.push_back({points[i], points[(i + 1) % points.size()]});
  k = std::min(k, all.size());
  const auto tree = build_figure_tree(all, {.most_in_leaf = in_leaf, .execution = Execution::serial});
  std::vector<Rational> square;
  std::vector<std::uint32_t> order(all.size()), in_ball, meeting, over;
  std::iota(order.begin(), order.end(), 0U);
  for (const std::uint32_t i : order) {
    square.push_back(squared_distance_exact(p, all[i]));
    if (square.back() <= Rational(radius) * Rational(radius)) in_ball.push_back(i);
    const Relation r = relate(all[i], box);
    if (r != Relation::disjoint) meeting.push_back(i);
    if (r == Relation::overlapping) over.push_back(i);
  }
  std::ranges::stable_sort(order, [&](std::uint32_t a, std::uint32_t b) { return square[a] < square[b]; });
  const auto found = nearest(tree, p, k, Ties::all);
  expect(found.size() >= k, "too few nearest segments");
  for (std::size_t i = 0; i < found.size(); ++i) expect(found[i].index == order[i], "the nearest segments");
  expect(found.size() == all.size() || square[order[found.size()]] != square[order[k - 1]],
         "a tie of segments is lost");
  expect(square[order[found.size() - 1]] == square[order[k - 1]], "segments that are no ties");
  expect(within(tree, p, radius) == in_ball, "segments within");
  expect(in_box(tree, box) == meeting, "segments in a box");
  expect(in_box(tree, box, {.touching = false}) == over, "segments that overlap a box");
  const auto split = build_split_tree(all, {.most_in_leaf = in_leaf, .execution = Execution::serial});
  expect(in_box(split, box) == meeting, "segments of a split tree in a box");
  expect(in_box(split, box, {.touching = false}) == over, "segments of a split tree that overlap a box");
}

void run(Entropy& e) {
  constexpr std::size_t most_points = 60, most_places = 8;
  const std::uint64_t form = e.below(4);
  const auto in_leaf = static_cast<std::uint32_t>(1 + e.below(10));
  std::vector<Point3> points;
  const std::size_t count = 1 + e.below(most_points);
  while (points.size() < count) {
    points.push_back(points.empty() || e.below(4) != 0 ? some_point(e, form) : points[e.below(points.size())]);
  }
  const KdTree3 tree = build_kd_tree(points, {.most_in_leaf = in_leaf, .execution = Execution::serial});
  const PointOctree octree = build_octree(points, {.most_in_leaf = in_leaf, .execution = Execution::serial});
  for (std::size_t i = 0; i == 0 || (i < most_places && !e.exhausted()); ++i) {
    const Point3 p = e.coin() ? points[e.below(count)] : some_point(e, form), a = some_point(e, form),
                 b = some_point(e, form);
    const Aabb3 box{{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
                    {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}};
    const std::size_t k = 1 + e.below(count);
    const double radius = std::fabs(coordinate(e, form));
    check(points, tree, octree, p, k, radius, box);
    if (i == 0) check_segments(points, in_leaf, p, k, radius, box);
  }
}

}  // namespace
}  // namespace plumb::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plumb::Entropy entropy = plumb::Entropy::from_bytes({data, size});
  plumb::fuzz::run(entropy);
  return 0;
}
