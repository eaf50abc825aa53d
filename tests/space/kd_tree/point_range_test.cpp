// Points in balls and boxes against each point asked exactly.
#include "plumb/space/kd_tree/point_range.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "certify/batch/take_instruction_set.hpp"
#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/certify/instruction_set.hpp"
#include "plumb/figure/aabb/relation.hpp"
#include "plumb/query/closest/closest.hpp"
#include "space/kd_tree/point_sets.hpp"

namespace plumb {
namespace {

using point_sets::Kind;
using Numbers = std::vector<std::uint32_t>;

template <class Point>
Numbers those_within(const std::vector<Point>& all, const Point& p, double radius) {
  Numbers numbers;
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    if (compare_distance(p, all[i], radius) != Sign::positive) numbers.push_back(i);
  }
  return numbers;
}

template <class Point>
Numbers those_in_box(const std::vector<Point>& all, const space::BoxOf<Point>& box) {
  Numbers numbers;
  const auto low = coordinates(box.min), high = coordinates(box.max);
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    const auto at = coordinates(all[i]);
    bool in = true;
    for (std::size_t a = 0; a < at.size(); ++a) in = in && low[a] <= at[a] && at[a] <= high[a];
    if (in) numbers.push_back(i);
  }
  return numbers;
}

template <class Point>
Numbers those_inside(const std::vector<Point>& all, const space::BoxOf<Point>& box) {
  Numbers numbers;
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    if (relate(box, {all[i], all[i]}) == Relation::overlapping) numbers.push_back(i);
  }
  return numbers;
}

template <class Point>
space::BoxOf<Point> box_around(const Point& p, const Point& q) {
  space::BoxOf<Point> box{p, p};
  box.min.x = std::min(p.x, q.x), box.max.x = std::max(p.x, q.x);
  box.min.y = std::min(p.y, q.y), box.max.y = std::max(p.y, q.y);
  if constexpr (!std::is_same_v<Point, Point2>) box.min.z = std::min(p.z, q.z), box.max.z = std::max(p.z, q.z);
  return box;
}

template <class Point>
class PointRange : public ::testing::Test {};
using PointTypes = ::testing::Types<Point2, Point3>;
TYPED_TEST_SUITE(PointRange, PointTypes);

TYPED_TEST(PointRange, FindsWhatIsAskedPointByPoint) {
  std::size_t found = 0, left_out = 0, at_border = 0, in_boxes = 0, inside_boxes = 0;
  for (std::uint64_t index = 0; index < battery::fitting(900u); ++index) {
    Entropy e(7321, index);
    const auto kind = static_cast<Kind>(index % point_sets::kinds);
    SCOPED_TRACE(testing::Message() << "start 7321 index " << index << ", "
                                    << point_sets::kind_names[index % point_sets::kinds]);
    const auto all = point_sets::points<TypeParam>(kind, 1 + e.below(60), e);
    const auto tree = build_kd_tree(all, {.most_in_leaf = static_cast<std::uint32_t>(1 + e.below(12))});
    const TypeParam p = point_sets::query(kind, all, e), q = all[e.below(all.size())];
    double radius = distance(p, q);
    if (e.below(4) == 0) radius = std::nextafter(radius, 0.0);
    if (!std::isfinite(radius)) radius = std::numeric_limits<double>::max();
    const Numbers expected = those_within(all, p, radius);
    ASSERT_EQ(within(tree, p, radius), expected);
    found += expected.size(), left_out += all.size() - expected.size();
    for (const TypeParam& x : all) at_border += compare_distance(p, x, radius) == Sign::zero ? 1 : 0;
    const auto box = box_around(q, all[e.below(all.size())]);
    const Numbers in = those_in_box(all, box);
    ASSERT_EQ(in_box(tree, box), in);
    const Numbers inside = those_inside(all, box);
    ASSERT_EQ(in_box(tree, box, {.touching = false}), inside);
    in_boxes += in.size(), inside_boxes += inside.size();
  }
  EXPECT_GT(found, battery::fitting(3000u));
  EXPECT_GT(left_out, battery::fitting(3000u));
  EXPECT_GT(at_border, battery::fitting(500u));
  EXPECT_GT(inside_boxes, battery::fitting(1000u));
  EXPECT_GT(in_boxes, inside_boxes + battery::fitting(1000u));
}

TYPED_TEST(PointRange, OfManyIsThatOfEach) {
  Entropy e(7322, 0);
  const auto all = point_sets::points<TypeParam>(Kind::sphere, battery::fitting(3000u), e);
  const auto tree = build_kd_tree(all);
  std::vector<TypeParam> queries;
  std::vector<space::BoxOf<TypeParam>> boxes;
  for (std::size_t i = 0; i < battery::fitting(5000u); ++i) {
    queries.push_back(i < 200 ? point_sets::query(Kind::lattice, all, e) : queries[i % 200]);
    boxes.push_back(box_around(all[e.below(all.size())], all[e.below(all.size())]));
  }
  const double radius = 0.25;
  for (const std::string_view set : batch_instruction_sets()) {
    certify::batch::take_instruction_set(set);
    for (const Execution execution : {Execution::serial, Execution::parallel}) {
      const PointLists lists = within(tree, queries, radius, execution);
      const PointLists in_boxes = in_box(tree, std::span<const space::BoxOf<TypeParam>>(boxes), execution);
      const PointLists inside =
          in_box(tree, std::span<const space::BoxOf<TypeParam>>(boxes), execution, {.touching = false});
      ASSERT_EQ(lists.size(), queries.size());
      ASSERT_EQ(in_boxes.size(), boxes.size());
      for (std::size_t i = 0; i < queries.size(); i += i < 200 ? 1 : 97) {
        const auto list = lists[i], in = in_boxes[i], within_sides = inside[i];
        ASSERT_EQ(Numbers(list.begin(), list.end()), those_within(all, queries[i], radius)) << i << " by " << set;
        ASSERT_EQ(Numbers(in.begin(), in.end()), those_in_box(all, boxes[i])) << i << " by " << set;
        ASSERT_EQ(Numbers(within_sides.begin(), within_sides.end()), those_inside(all, boxes[i])) << i << " by " << set;
      }
    }
  }
  certify::batch::take_instruction_set({});
}

// Leaves of one point, so that a ball holds more of them than are kept at a time; equal points, huge and tiny radii.
TYPED_TEST(PointRange, OfManyOfEachKind) {
  std::size_t most = 0, equal = 0, extreme = 0;
  for (std::uint64_t index = 0; index < point_sets::kinds; ++index) {
    Entropy e(7323, index);
    const auto kind = static_cast<Kind>(index % point_sets::kinds);
    SCOPED_TRACE(testing::Message() << "start 7323 index " << index << ", "
                                    << point_sets::kind_names[index % point_sets::kinds]);
    const auto all = point_sets::points<TypeParam>(kind, 400, e);
    const auto tree = build_kd_tree(all, {.most_in_leaf = 1});
    for (const std::uint8_t is_equal : tree.equal) equal += is_equal;
    std::vector<TypeParam> queries;
    for (std::size_t i = 0; i < 40; ++i) queries.push_back(point_sets::query(kind, all, e));
    double radius = distance(queries[e.below(40)], all[e.below(all.size())]);
    if (!std::isfinite(radius)) radius = std::numeric_limits<double>::max();
    extreme += radius > 1e150 || radius < 1e-150 ? 1 : 0;
    const PointLists lists = within(tree, queries, radius, Execution::serial);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const Numbers list(lists[i].begin(), lists[i].end());
      ASSERT_EQ(list, within(tree, queries[i], radius)) << i;
      if (i % 20 == 0) {
        ASSERT_EQ(list, those_within(all, queries[i], radius)) << i;
      }
      most = std::max(most, list.size());
    }
  }
  EXPECT_GT(most, 300u);
  EXPECT_GT(equal, 10u);
  EXPECT_GT(extreme, 0u);
}

TEST(PointRangeOfATree, NamesWhatIsRefused) {
  using ::testing::HasSubstr;
  const KdTree3 none = build_kd_tree(std::vector<Point3>{}), one = build_kd_tree(std::vector<Point3>{{0, 0, 0}});
  EXPECT_EQ(within(none, {0, 0, 0}, 1), Numbers{});
  EXPECT_EQ(in_box(none, {{0, 0, 0}, {1, 1, 1}}), Numbers{});
  EXPECT_EQ(in_box(one, {{1, 1, 1}, {-1, -1, -1}}), Numbers{});
  EXPECT_EQ(within(one, {0, 0, 0}, 0), Numbers{0});
  EXPECT_THAT(text_of<InvalidShape>([&] {
                (void)within(one, {0, 0, 0}, -1);
              }),
              HasSubstr("within: radius is negative"));
  EXPECT_THAT(text_of<NonFinite>([&] { (void)within(one, {0, 0, 0}, HUGE_VAL); }), HasSubstr("within: radius is inf"));
  EXPECT_THAT(text_of<NonFinite>([&] { (void)within(one, {0, 0, HUGE_VAL}, 1); }), HasSubstr("p.z is inf"));
  EXPECT_THAT(text_of<NonFinite>([&] {
                (void)in_box(one, {{0, std::nan(""), 0}, {1, 1, 1}});
              }),
              HasSubstr("in_box: box.min.y is nan"));
}

}  // namespace
}  // namespace plumb
