// The laws of the tree: every point once, planes between halves, equal leaves, the same on any number of threads.
#include "plumb/space/kd_tree/kd_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "certify/sanitized.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "space/kd_tree/point_sets.hpp"
#include "space/kd_tree/select.hpp"

namespace plumb {
namespace {

using point_sets::Kind;

template <class Point>
class KdTreeTest : public ::testing::Test {};
using PointTypes = ::testing::Types<Point2, Point3>;
TYPED_TEST_SUITE(KdTreeTest, PointTypes);

template <class Point>
void expect_laws(const KdTree<Point>& tree, const std::vector<Point>& points, std::uint32_t most_in_leaf) {
  constexpr std::size_t d = KdTree<Point>::dimension;
  ASSERT_EQ(tree.count, points.size());
  ASSERT_EQ(tree.planes.size(), tree.leaves() - 1);
  ASSERT_EQ(tree.axes.size(), tree.leaves() - 1);
  std::vector<std::uint32_t> sorted = tree.numbers;
  std::sort(sorted.begin(), sorted.end());
  for (std::uint32_t i = 0; i < sorted.size(); ++i) ASSERT_EQ(sorted[i], i);
  for (std::size_t leaf = 0; leaf < tree.leaves(); ++leaf) {
    const std::uint32_t first = tree.first(leaf), count = tree.first(leaf + 1) - first;
    ASSERT_LE(count, most_in_leaf);
    ASSERT_GE(count + 1, (tree.count + tree.leaves() - 1) / tree.leaves());
    ASSERT_TRUE(std::is_sorted(tree.numbers.begin() + first, tree.numbers.begin() + first + count));
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto at = coordinates(points[tree.numbers[first + i]]);
      for (std::size_t a = 0; a < d; ++a) ASSERT_EQ(tree.coordinates[d * first + a * count + i], at[a]);
      for (std::size_t node = leaf + tree.leaves() - 1; node != 0; node = (node - 1) / 2) {
        const std::size_t parent = (node - 1) / 2;
        if (node % 2 == 1) {
          ASSERT_LE(at[tree.axes[parent]], tree.planes[parent]);
        } else {
          ASSERT_GE(at[tree.axes[parent]], tree.planes[parent]);
        }
      }
    }
  }
}

TYPED_TEST(KdTreeTest, KeepsItsLaws) {
  for (std::uint64_t index = 0; index < battery::fitting(360u); ++index) {
    SCOPED_TRACE(testing::Message() << "start 7311 index " << index);
    Entropy e(7311, index);
    const auto kind = static_cast<Kind>(index % point_sets::kinds);
    const auto all = point_sets::points<TypeParam>(kind, index < 18 ? index / 9 : e.below(300), e);
    const auto most = static_cast<std::uint32_t>(1 + e.below(20));
    expect_laws(build_kd_tree(all, {.most_in_leaf = most}), all, most);
  }
}

TYPED_TEST(KdTreeTest, IsTheSameOnAnyNumberOfThreads) {
  for (std::uint64_t index = 0; index < point_sets::kinds; ++index) {
    Entropy e(7312, index);
    const auto all = point_sets::points<TypeParam>(static_cast<Kind>(index), battery::fitting(20'000u), e);
    const auto serial = build_kd_tree(all, {.execution = Execution::serial});
    for (const std::size_t threads : {1u, 2u}) {
      const ThreadLimit control(threads);
      const auto parallel = build_kd_tree(all);
      EXPECT_EQ(parallel.planes, serial.planes);
      EXPECT_EQ(parallel.axes, serial.axes);
      EXPECT_EQ(parallel.numbers, serial.numbers);
    }
  }
}

TEST(KdTreeSize, IsAsStated) {
  for (const std::size_t n : {1000u, 4096u, 10'000u}) {
    Entropy e(7313, n);
    const auto space = point_sets::points<Point3>(Kind::sphere, n, e);
    const KdTree3 tree = build_kd_tree(space);
    EXPECT_EQ(memory_of(tree), 28 * n + 10 * (tree.leaves() - 1) + 8 * KdTree3::padding);
    EXPECT_LE(tree.leaves(), n / 4);
    const auto plane = point_sets::points<Point2>(Kind::sphere, n, e);
    const KdTree2 flat = build_kd_tree(plane);
    EXPECT_EQ(memory_of(flat), 20 * n + 10 * (flat.leaves() - 1) + 8 * KdTree2::padding);
  }
}

TEST(KdTreeSelect, PutsTheMiddleWhereSortingWould) {
  for (std::uint64_t index = 0; index < battery::fitting(300u); ++index) {
    Entropy e(7314, index);
    const std::size_t n = 1 + e.below(index % 10 == 0 ? 5000 : 100);
    std::vector<std::uint64_t> items(n);
    for (std::size_t i = 0; i < n; ++i) items[i] = index % 3 == 0 ? i : index % 3 == 1 ? n - i : e.bits(20) << 20 | i;
    std::vector<std::uint64_t> sorted = items;
    std::sort(sorted.begin(), sorted.end());
    const std::size_t middle = e.below(n);
    space::kd::select(items.data(), items.data() + middle, items.data() + n, std::less<>());
    EXPECT_EQ(items[middle], sorted[middle]) << "start 7314 index " << index;
    for (std::size_t i = 0; i < n; ++i) EXPECT_EQ(items[i] < sorted[middle], i < middle) << i;
  }
}

}  // namespace
}  // namespace plumb
