// Is each point in the leaf that comparisons name, and what is in a box in it, on the hard families?
#include "plumb/space/octree/point_octree.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/figure/aabb/relation.hpp"
#include "space/octree/octree_laws.hpp"
#include "space/octree/scenes.hpp"

namespace plumb {
namespace {

template <std::size_t D>
auto built(const std::vector<typename CellKinds<D>::Point>& points, const OctreeOptions& options) {
  if constexpr (D == 2) {
    return build_quadtree(points, options);
  } else {
    return build_octree(points, options);
  }
}

template <class Box, class Point>
bool holds(const Box& box, const Point& p) {
  const auto low = coordinates(box.min), high = coordinates(box.max), x = coordinates(p);
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (!(low[k] <= x[k] && x[k] <= high[k])) return false;
  }
  return true;
}

template <class Dimension>
class Octrees : public ::testing::Test {};
using Dimensions = ::testing::Types<std::integral_constant<std::size_t, 2>, std::integral_constant<std::size_t, 3>>;
TYPED_TEST_SUITE(Octrees, Dimensions);

TYPED_TEST(Octrees, EachPointIsInItsLeafAndFoundInBoxes) {
  constexpr std::size_t D = TypeParam::value;
  std::size_t found = 0, deepest = 0, crowded = 0, outside = 0, inside = 0;
  scenes::on_scenes(
      721 + D, battery::sanitized ? 4 : 20, [&](scenes::Family family, Entropy& e, const std::string& text) {
        const auto points = scenes::points_of<D>(family, 1 + e.below(120), e);
        const OctreeOptions options{.most_in_leaf = static_cast<std::uint32_t>(1 + e.below(5)),
                                    .most_depth = static_cast<std::uint32_t>(e.coin() ? 31 : e.below(6))};
        const auto tree = built<D>(points, options);
        ASSERT_EQ(octree_laws::broken(tree.cells, options.most_depth), "") << text;
        std::vector<int> seen(points.size());
        const unsigned most_depth = std::min(options.most_depth, CellFrame<D>::levels);
        for (std::uint32_t node = 0; node < tree.cells.nodes.size(); ++node) {
          const CellNode& n = tree.cells.nodes[node];
          const auto cell = box_of(tree.cells, node);
          for (std::uint32_t i = n.begin; i < n.end; ++i) {
            EXPECT_TRUE(octree_laws::is_in_cell(cell, tree.points[i])) << text;
            if (n.is_leaf()) ++seen[tree.cells.items[i]];
            EXPECT_EQ(locate(tree.cells, tree.points[i]) == node, n.is_leaf()) << text;
          }
          const bool is_full = n.count() > options.most_in_leaf;
          EXPECT_EQ(n.is_leaf(), !is_full || level_of<D>(n.code) == most_depth) << text;
          crowded += is_full && n.is_leaf() ? 1 : 0;
          deepest = std::max<std::size_t>(deepest, level_of<D>(n.code));
        }
        EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(points.size())) << text;
        for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(tree.points[i], points[tree.cells.items[i]]);
        for (int k = 0; k < 4; ++k) {
          const auto box = scenes::box_of<D>(family, e);
          std::vector<std::uint32_t> expected, within;
          for (std::uint32_t i = 0; i < points.size(); ++i) {
            if (holds(box, points[i])) expected.push_back(i);
            if (relate(box, {points[i], points[i]}) == Relation::overlapping) within.push_back(i);
          }
          EXPECT_EQ(in_box(tree, box), expected) << text;
          EXPECT_EQ(in_box(tree, box, {.touching = false}), within) << text;
          inside += within.size();
          found += expected.size();
          const auto place = scenes::point_of<D>(family, e);
          const std::uint32_t leaf = locate(tree.cells, place);
          outside += leaf == no_cell ? 1 : 0;
          EXPECT_EQ(leaf == no_cell, !octree_laws::is_in_cell(box_of(tree.cells, 0), place)) << text;
          EXPECT_TRUE(leaf == no_cell || octree_laws::is_in_cell(box_of(tree.cells, leaf), place)) << text;
        }
      });
  EXPECT_GT(inside, battery::sanitized ? 20u : 200u);
  EXPECT_GT(found, inside + 200);
  EXPECT_GT(found, 500u);
  EXPECT_GT(crowded, 5u);
  EXPECT_GT(outside, 5u);
  EXPECT_EQ(deepest, CellFrame<D>::levels);
}

TYPED_TEST(Octrees, IsTheSameOnAnyNumberOfThreads) {
  constexpr std::size_t D = TypeParam::value;
  for (const scenes::Family family : {scenes::Family::uniform, scenes::Family::clustered, scenes::Family::ulps}) {
    Entropy e(731, static_cast<std::uint64_t>(family));
    const auto points = scenes::points_of<D>(family, battery::sanitized ? 5'000 : 50'000, e);
    const auto serial = built<D>(points, {.execution = Execution::serial});
    for (const std::size_t threads : {1u, 2u}) {
      const ThreadLimit control(threads);
      const auto tree = built<D>(points, {});
      EXPECT_EQ(tree.cells, serial.cells);
      EXPECT_EQ(tree.points, serial.points);
    }
  }
}

TYPED_TEST(Octrees, ManyEqualPointsAreOneLeaf) {
  constexpr std::size_t D = TypeParam::value;
  const typename CellKinds<D>::Point p{};
  const std::size_t n = battery::sanitized ? 20'000 : 1'000'000;
  const std::vector<typename CellKinds<D>::Point> points(n, p);
  const auto tree = built<D>(points, {});
  EXPECT_EQ(tree.cells.nodes.size(), 1 + (std::size_t{1} << D) * CellFrame<D>::levels);
  EXPECT_EQ(tree.cells.nodes[locate(tree.cells, p)].count(), n);
  EXPECT_EQ(in_box(tree, {p, p}).size(), n);
}

TYPED_TEST(Octrees, NothingHasNoCells) {
  constexpr std::size_t D = TypeParam::value;
  const auto tree = built<D>({}, {});
  EXPECT_EQ(octree_laws::broken(tree.cells, 31), "");
  EXPECT_EQ(locate(tree.cells, typename CellKinds<D>::Point{}), no_cell);
  EXPECT_TRUE(in_box(tree, typename CellKinds<D>::Box{}).empty());
}

TEST(Octree, RefusesWhatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Point3> points{{0, 0, 0}, {0, nan, 0}};
  EXPECT_THAT(text_of<NonFinite>([&] { (void)build_octree(points); }),
              ::testing::HasSubstr("build_octree: points[1].y is nan"));
  EXPECT_THAT(text_of<InvalidShape>([&] { (void)build_quadtree(std::vector<Point2>{}, {.most_in_leaf = 0}); }),
              ::testing::HasSubstr("options.most_in_leaf is 0"));
  EXPECT_THAT(text_of<NonFinite>([&] {
                (void)in_box(PointOctree{}, Aabb3{{0, 0, 0}, {1, 1, nan}});
              }),
              ::testing::HasSubstr("in_box: box.max.z is nan"));
  const PointOctree tree = build_octree(std::vector<Point3>{{0, 0, 0}, {1, 1, 1}});
  EXPECT_EQ(locate(tree.cells, {nan, 0, 0}), no_cell);
  EXPECT_TRUE(in_box(tree, Aabb3{{1, 0, 0}, {0, 1, 1}}).empty());
}

}  // namespace
}  // namespace plumb
