// The nearest points against all points sorted by exact comparisons, of every kind of points; ties; and what is
// refused.
#include "plumb/space/kd_tree/nearest_point.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "certify/batch/take_instruction_set.hpp"
#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/certify/instruction_set.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/query/closest/closest.hpp"
#include "space/kd_tree/point_search.hpp"
#include "space/kd_tree/point_sets.hpp"

namespace plumb {
namespace {

using point_sets::Kind;

template <class Point>
class NearestPointTest : public ::testing::Test {};
using PointTypes = ::testing::Types<Point2, Point3>;
TYPED_TEST_SUITE(NearestPointTest, PointTypes);

TYPED_TEST(NearestPointTest, IsTheFirstOfAllSorted) {
  std::array<std::size_t, point_sets::kinds> ties{};
  std::size_t told_more = 0, equal_nodes = 0;
  for (std::uint64_t index = 0; index < battery::fitting(900u); ++index) {
    Entropy e(7301, index);
    const auto kind = static_cast<Kind>(index % point_sets::kinds);
    SCOPED_TRACE(testing::Message() << "start 7301 index " << index << ", "
                                    << point_sets::kind_names[index % point_sets::kinds]);
    const std::size_t n = 1 + e.below(index % 5 == 0 ? 120 : 30);
    auto all = point_sets::points<TypeParam>(kind, n, e);
    if (index / point_sets::kinds % 2 == 1) {  // most in three places, so that all below some nodes are equal
      for (TypeParam& q : all) q = e.below(8) == 0 ? q : all[e.below(std::min<std::size_t>(n, 3))];
    }
    const auto tree = build_kd_tree(all, {.most_in_leaf = static_cast<std::uint32_t>(1 + e.below(12)),
                                          .execution = e.coin() ? Execution::serial : Execution::parallel});
    const TypeParam p = point_sets::query(kind, all, e);
    const auto order = point_sets::sorted_by_distance(all, p);
    const NearestPoint first = nearest(tree, p);
    ASSERT_EQ(first.index, order[0]);
    ASSERT_EQ(first.distance, distance(p, all[order[0]]));
    const std::size_t k = 1 + e.below(n);
    const auto several = nearest(tree, p, k);
    ASSERT_EQ(several.size(), k);
    for (std::size_t i = 0; i < k; ++i) {
      ASSERT_EQ(several[i].index, order[i]) << i << " of " << k;
      ASSERT_EQ(several[i].distance, distance(p, all[order[i]]));
    }
    std::size_t more = k;
    while (more < n && compare_distance(p, all[order[k - 1]], all[order[more]]) == Sign::zero) ++more;
    const auto tied = nearest(tree, p, k, Ties::all);
    ASSERT_EQ(tied.size(), more);
    for (std::size_t i = 0; i < more; ++i) {
      ASSERT_EQ(tied[i].index, order[i]) << i << " of " << more;
      ASSERT_EQ(tied[i].distance, distance(p, all[order[i]]));
    }
    ASSERT_EQ(space::kd::count_ties_above(tree, p, all[order[k - 1]], order[k - 1]), more - k);
    ties[index % point_sets::kinds] += more > k ? 1 : 0, told_more += more - k;
    equal_nodes += static_cast<std::size_t>(std::ranges::count(tree.equal, 1));
  }
  for (const Kind kind : {Kind::lattice, Kind::equal, Kind::ulps, Kind::tiny}) {
    const std::size_t tied = ties[static_cast<std::size_t>(kind)];
    if (battery::reaches_rare) {
      EXPECT_GT(tied, 10u) << point_sets::kind_names[static_cast<std::size_t>(kind)];
    }
  }
  EXPECT_GT(told_more, battery::fitting(500u));
  EXPECT_GT(equal_nodes, battery::fitting(1000u));
}

TYPED_TEST(NearestPointTest, OfManyIsThatOfEach) {
  for (const Kind kind : {Kind::family, Kind::lattice, Kind::clusters, Kind::huge}) {
    Entropy e(7302, static_cast<std::uint64_t>(kind));
    const auto all = point_sets::points<TypeParam>(kind, battery::fitting(1500u), e);
    const auto tree = build_kd_tree(all);
    std::vector<TypeParam> queries;
    for (std::size_t i = 0; i < battery::fitting(2500u); ++i) {
      // Mostly few, so that blocks of many queries are met without many exact answers.
      queries.push_back(i < 200 ? point_sets::query(kind, all, e) : queries[i % 200]);
    }
    constexpr std::size_t k = 3;
    std::vector<NearestPoint> expected, expected_k;
    for (std::size_t i = 0; i < std::min<std::size_t>(200, queries.size()); ++i) {
      expected.push_back(nearest(tree, queries[i]));
      for (const NearestPoint& q : nearest(tree, queries[i], k)) expected_k.push_back(q);
    }
    for (const std::string_view set : batch_instruction_sets()) {
      certify::batch::take_instruction_set(set);
      for (const std::size_t threads : {1u, 2u}) {
        const ThreadLimit control(threads);
        std::vector<NearestPoint> out(queries.size()), out_k(queries.size() * k);
        nearest(tree, queries, out, threads == 1 ? Execution::serial : Execution::parallel);
        nearest(tree, queries, k, out_k, threads == 1 ? Execution::serial : Execution::parallel);
        for (std::size_t i = 0; i < queries.size(); ++i) {
          ASSERT_EQ(out[i], expected[i % 200]) << i << " by " << set;
          for (std::size_t m = 0; m < k; ++m) ASSERT_EQ(out_k[k * i + m], expected_k[i % 200 * k + m]) << i;
        }
      }
    }
    certify::batch::take_instruction_set({});
  }
}

TEST(NearestPointOfATree, ManyEqualPointsAndOneUlpOff) {
  std::vector<Point3> all(battery::fitting(1'000'000u), Point3{0.1, 0.2, 0.3});
  const KdTree3 equal = build_kd_tree(all);
  EXPECT_EQ(nearest(equal, {0.1, 0.2, 0.3}), (NearestPoint{0, 0}));
  const auto five = nearest(equal, {0.1, 0.2, 0.3}, 5);
  for (std::uint32_t i = 0; i < 5; ++i) EXPECT_EQ(five[i], (NearestPoint{i, 0}));
  all[all.size() / 2].x = std::nextafter(0.1, 1);
  EXPECT_EQ(nearest(build_kd_tree(all), {1, 0.2, 0.3}).index, all.size() / 2);
}

TEST(NearestPointOfATree, UpToNineOfMoreThatTie) {
  for (const int square : {1, 2, 5, 9, 26}) {  // 6, 12, 24, 30 and 72 lattice points are as far
    Entropy e(7303, static_cast<std::uint64_t>(square));
    std::vector<Point3> all;
    for (int x = -7; x <= 7; ++x) {
      for (int y = -7; y <= 7; ++y) {
        for (int z = -7; z <= 7; ++z) {
          const int own = x * x + y * y + z * z;
          if (own == square || own == 50)
            all.insert(all.begin() + static_cast<std::ptrdiff_t>(e.below(all.size() + 1)), {1.0 * x, 1.0 * y, 1.0 * z});
        }
      }
    }
    const auto order = point_sets::sorted_by_distance(all, Point3{});
    for (const std::uint32_t most_in_leaf : {1u, 8u, 200u}) {
      const auto tree = build_kd_tree(all, {.most_in_leaf = most_in_leaf});
      for (const std::string_view set : batch_instruction_sets()) {
        certify::batch::take_instruction_set(set);
        for (std::size_t k = 1; k <= 9; ++k) {
          const auto found = nearest(tree, {}, k);
          for (std::size_t i = 0; i < k; ++i) ASSERT_EQ(found[i].index, order[i]) << i << " of " << k << " by " << set;
        }
      }
    }
  }
  certify::batch::take_instruction_set({});
}

TEST(NearestPointOfATree, FromOneEndOfDoublesToTheOther) {
  const double most = std::numeric_limits<double>::max(), least = 0x1p-1074;
  const std::vector<Point3> all{{most, most, most}, {most, most, 0}, {0, 0, least}, {0, 0, 3 * least}, {1, 0, 0}};
  const KdTree3 tree = build_kd_tree(all, {.most_in_leaf = 1});
  EXPECT_EQ(nearest(tree, {-most, 0, 0}).index, 2u);
  EXPECT_EQ(nearest(tree, {-most, 0, 0}).distance, most);
  EXPECT_EQ(nearest(tree, {0, 0, 2 * least}), (NearestPoint{2, least}));
  EXPECT_EQ(nearest(tree, {0, 0, 2 * least}, 1, Ties::all).size(), 2u);
  EXPECT_EQ(nearest(tree, {most, most, 1}).index, 1u);
}

TEST(NearestPointOfATree, NamesWhatIsRefused) {
  using ::testing::HasSubstr;
  const KdTree2 none = build_kd_tree(std::vector<Point2>{}), two = build_kd_tree(std::vector<Point2>{{0, 0}, {1, 0}});
  EXPECT_THAT(text_of<InvalidShape>([&] { (void)nearest(none, {0, 0}); }), HasSubstr("nearest: 1 of 0 points"));
  EXPECT_EQ(nearest(two, {0, 0}, 3), nearest(two, {0, 0}, 2));
  EXPECT_TRUE(nearest(none, {0, 0}, 3).empty());
  EXPECT_TRUE(nearest(two, {0, 0}, 0).empty());
  EXPECT_THAT(text_of<NonFinite>([&] { (void)nearest(two, {0, std::nan("")}); }), HasSubstr("nearest: p.y is nan"));
  const std::vector<Point2> queries{{0, 0}, {HUGE_VAL, 0}};
  std::vector<NearestPoint> out(2);
  EXPECT_THAT(text_of<NonFinite>([&] { nearest(two, queries, out); }), HasSubstr("queries[1].x is inf"));
  out.resize(1);
  EXPECT_THAT(text_of<UnequalLengths>([&] { nearest(two, queries, out); }), HasSubstr("out has 1 items, but 2"));
  EXPECT_THAT(text_of<NonFinite>([&] { (void)build_kd_tree(queries); }),
              HasSubstr("build_kd_tree: points[1].x is inf"));
  EXPECT_THAT(text_of<InvalidShape>([&] { (void)build_kd_tree(std::vector<Point2>{}, {.most_in_leaf = 0}); }),
              HasSubstr("most_in_leaf"));
}

}  // namespace
}  // namespace plumb
