// The nearest figures against all figures sorted by their exact distances, what is within and in boxes against each one
// asked, of every kind of figures; ties, batches, and what is refused.
#include "plumb/space/kd_tree/figure_tree.hpp"

#include <gmock/gmock.h>

#include <numeric>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/query/closest/closest.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/space/kd_tree/figure_range.hpp"
#include "plumb/space/kd_tree/nearest_figure.hpp"
#include "space/kd_tree/figure_sets.hpp"

namespace plumb {
namespace {

using Numbers = std::vector<std::uint32_t>;

/// The figures' squares of distances from p, and their numbers, nearest first, of equally near ones the lowest.
template <class Figure>
struct Sorted {
  std::vector<Rational> square;
  Numbers order;

  Sorted(const std::vector<Figure>& all, const typename FigureTree<Figure>::Point& p) {
    for (std::uint32_t i = 0; i < all.size(); ++i) {
      square.push_back(squared_distance_exact(p, all[i]));
      order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(), [&](auto i, auto k) { return square[i] < square[k]; });
  }
};

template <class Figure>
class FigureTreeTest : public ::testing::Test {};
using Figures = ::testing::Types<Aabb2, Segment2, Triangle2, Aabb3, Segment3, Triangle3>;
TYPED_TEST_SUITE(FigureTreeTest, Figures);

TYPED_TEST(FigureTreeTest, AnswersAsASearchThroughAllDoes) {
  std::array<std::size_t, figure_sets::kinds> ties{};
  std::size_t found = 0, left_out = 0, at_border = 0, in_boxes = 0, not_in_boxes = 0, touching = 0;
  for (std::uint64_t index = 0; index < battery::fitting(192u); ++index) {
    Entropy e(7351, index);
    const std::size_t kind = index % figure_sets::kinds;
    SCOPED_TRACE(testing::Message() << "start 7351 index " << index << ", " << figure_sets::name_of(kind));
    const std::size_t n = 1 + e.below(index % 5 == 0 ? 40 : 14);
    const auto [all, points] = figure_sets::figures<TypeParam>(kind, n, e);
    const auto tree = build_figure_tree(all, {.most_in_leaf = static_cast<std::uint32_t>(1 + e.below(12)),
                                              .execution = e.coin() ? Execution::serial : Execution::parallel});
    const auto p = figure_sets::place<TypeParam>(kind, {all, points}, e);
    const Sorted<TypeParam> sorted(all, p);
    const NearestFigure first = nearest(tree, p);
    ASSERT_EQ(first.index, sorted.order[0]);
    const std::size_t k = 1 + e.below(n);
    std::size_t more = k;
    while (more < n && sorted.square[sorted.order[k - 1]] == sorted.square[sorted.order[more]]) ++more;
    const auto several = nearest(tree, p, k), tied = nearest(tree, p, k, Ties::all);
    ASSERT_EQ(several.size(), k);
    ASSERT_EQ(tied.size(), more);
    for (std::size_t i = 0; i < more; ++i) {
      ASSERT_EQ(tied[i].index, sorted.order[i]) << i << " of " << more;
      ASSERT_EQ(tied[i].distance, distance(p, all[sorted.order[i]]));
      if (i < k) {
        ASSERT_EQ(several[i], tied[i]) << i << " of " << k;
      }
    }
    ties[kind] += more > k ? 1 : 0;

    double radius = first.distance + (tied.back().distance - first.distance) / 2;
    if (e.coin()) radius = tied.back().distance;
    if (!std::isfinite(radius)) radius = std::numeric_limits<double>::max();
    const Rational square = Rational(radius) * Rational(radius);
    Numbers in_ball;
    for (std::uint32_t i = 0; i < n; ++i) {
      at_border += sorted.square[i] == square ? 1 : 0;
      if (sorted.square[i] <= square) in_ball.push_back(i);
    }
    ASSERT_EQ(within(tree, p, radius), in_ball);
    found += in_ball.size(), left_out += n - in_ball.size();

    const auto box = figure_sets::spanned<typename FigureTree<TypeParam>::Box>({p, points[e.below(points.size())], p});
    Numbers meeting, over;
    for (std::uint32_t i = 0; i < n; ++i) {
      if (intersects(all[i], box)) meeting.push_back(i);
      if (relate(all[i], box) == Relation::overlapping) over.push_back(i);
    }
    ASSERT_EQ(in_box(tree, box), meeting);
    ASSERT_EQ(in_box(tree, box, {.touching = false}), over);
    touching += meeting.size() - over.size();
    in_boxes += meeting.size(), not_in_boxes += n - meeting.size();
  }
  EXPECT_GT(found, battery::fitting(400u));
  EXPECT_GT(left_out, battery::fitting(200u));
  EXPECT_GT(in_boxes, battery::fitting(400u));
  EXPECT_GT(not_in_boxes, battery::fitting(150u));
  EXPECT_GT(touching, battery::fitting(100u));
  if (battery::reaches_rare) {
    EXPECT_GT(at_border, 20u);
    EXPECT_GT(std::accumulate(ties.begin(), ties.end(), std::size_t{0}), 20u);
    EXPECT_GT(ties[static_cast<std::size_t>(point_sets::Kind::equal)], 5u);
  }
}

TEST(AFigureTree, AnswersOfManyThoseOfEach) {
  for (const auto kind : {point_sets::Kind::lattice, point_sets::Kind::sphere}) {
    Entropy e(7352, static_cast<std::uint64_t>(kind));
    const auto set = figure_sets::figures<Triangle3>(static_cast<std::size_t>(kind), 60, e);
    const auto tree = build_figure_tree(set.figures);
    std::vector<Point3> queries;
    std::vector<Aabb3> boxes;
    for (std::size_t i = 0; i < 300; ++i) {
      const Point3 p = i < 40 ? figure_sets::place<Triangle3>(static_cast<std::size_t>(kind), set, e) : queries[i % 40];
      queries.push_back(p), boxes.push_back(figure_sets::spanned<Aabb3>({p, queries[i / 2], p}));
    }
    for (const std::size_t threads : {1u, 2u}) {
      const ThreadLimit control(threads);
      const Execution execution = threads == 1 ? Execution::serial : Execution::parallel;
      std::vector<NearestFigure> one(queries.size()), three(3 * queries.size());
      nearest(tree, queries, one, execution);
      nearest(tree, queries, 3, three, execution);
      const FigureLists balls = within(tree, queries, 0.5, execution), windows = in_box(tree, boxes, execution),
                        over = in_box(tree, boxes, execution, {.touching = false});
      ASSERT_EQ(balls.size(), queries.size());
      ASSERT_EQ(windows.size(), queries.size());
      const auto list = [](std::span<const std::uint32_t> numbers) { return Numbers(numbers.begin(), numbers.end()); };
      for (std::size_t i = 0; i < queries.size(); ++i) {
        ASSERT_EQ(one[i], three[3 * i]) << i;
        ASSERT_EQ(one[i], one[i < 40 ? i : i % 40]) << i;
        if (i % 16 != 0 && i >= 8) continue;
        ASSERT_EQ(one[i], nearest(tree, queries[i])) << i;
        const auto several = nearest(tree, queries[i], 3);
        for (std::size_t m = 0; m < 3; ++m) ASSERT_EQ(three[3 * i + m], several[m]) << i;
        ASSERT_EQ(list(balls[i]), within(tree, queries[i], 0.5)) << i;
        ASSERT_EQ(list(windows[i]), in_box(tree, boxes[i])) << i;
        ASSERT_EQ(list(over[i]), in_box(tree, boxes[i], {.touching = false})) << i;
      }
    }
  }
}

TEST(AFigureTree, HoldsManyEqualFigures) {
  const std::size_t n = battery::fitting(1'000'000u);
  std::vector<Segment2> all(n, Segment2{{0.1, 0.2}, {0.3, 0.7}});
  const auto equal = build_figure_tree(all);
  EXPECT_EQ(equal.figures.size(), n);
  EXPECT_EQ(in_box(equal, {{0, 0}, {1, 1}}).size(), n);
  all.resize(battery::fitting(20'000u));
  all[all.size() / 2].b.x = std::nextafter(0.3, 1);
  const auto one_off = build_figure_tree(all);
  EXPECT_EQ(nearest(one_off, {1, 0.7}).index, all.size() / 2);
  const auto two = nearest(one_off, {1, 0.7}, 2);
  EXPECT_EQ(two[1].index, 0u);
  EXPECT_EQ(two[0].distance, two[1].distance);  // to the nearest double
  EXPECT_EQ(nearest(one_off, {0.1, 0.2}, 1, Ties::all).size(), all.size());
}

TEST(AFigureTree, TellsSquaresThatDoublesRoundAlike) {
  // From the diagonal's ends (1, 1) and (0, 0), 2^-60 apart: the nearer one is the last.
  const std::vector<Segment3> all{{{2, 0, 0}, {2, 4, 0x1p-60}}, {{2, 0, 1}, {2, 4, 1}}, {{2, 0, 0x1p-61}, {2, 4, 0}}};
  const auto tree = build_figure_tree(all);
  const auto found = nearest(tree, {0, 3, 0}, 2);
  EXPECT_EQ(found[0].index, 2u);
  EXPECT_EQ(found[1].index, 0u);
  EXPECT_EQ(found[0].distance, found[1].distance);
  EXPECT_EQ(within(tree, {0, 3, 0}, 2), (Numbers{}));
  EXPECT_EQ(within(tree, {0, 3, 0}, std::nextafter(2.0, 3)), (Numbers{0, 2}));
}

TEST(AFigureTree, NamesWhatIsRefused) {
  using ::testing::HasSubstr;
  const auto none = build_figure_tree(std::vector<Triangle2>{});
  const auto two = build_figure_tree(std::vector<Triangle2>(2, Triangle2{{0, 0}, {1, 0}, {0, 1}}));
  const double nan = std::nan("");
  EXPECT_TRUE(within(none, {0, 0}, 1).empty());
  EXPECT_TRUE(in_box(none, {{0, 0}, {1, 1}}).empty());
  EXPECT_TRUE(in_box(two, {{1, 1}, {0, 0}}).empty());
  EXPECT_TRUE(nearest(two, {0, 0}, 0).empty());
  EXPECT_THAT(text_of<InvalidShape>([&] { (void)nearest(none, {0, 0}); }), HasSubstr("nearest: 1 of 0 figures"));
  EXPECT_EQ(nearest(two, {0, 0}, 3), nearest(two, {0, 0}, 2));
  EXPECT_TRUE(nearest(none, {0, 0}, 3).empty());
  EXPECT_THAT(text_of<NonFinite>([&] { (void)nearest(two, {0, nan}); }), HasSubstr("nearest: p.y is nan"));
  EXPECT_THAT(text_of<NonFinite>([&] { (void)within(two, {0, 0}, nan); }), HasSubstr("within: radius"));
  EXPECT_THAT(text_of<InvalidShape>([&] { (void)within(two, {0, 0}, -1); }), HasSubstr("negative"));
  EXPECT_THAT(text_of<NonFinite>([&] {
                (void)in_box(two, {{0, 0}, {1, nan}});
              }),
              HasSubstr("in_box: box.max.y is nan"));
  const std::vector<Point2> queries{{0, 0}, {HUGE_VAL, 0}};
  std::vector<NearestFigure> out(2);
  EXPECT_THAT(text_of<NonFinite>([&] { nearest(two, queries, out); }), HasSubstr("queries[1].x is inf"));
  out.resize(1);
  EXPECT_THAT(text_of<UnequalLengths>([&] { nearest(two, queries, out); }), HasSubstr("out has 1 items, but 2"));
  EXPECT_THAT(text_of<NonFinite>([&] {
                (void)build_figure_tree(std::vector<Segment3>{{{0, 0, 0}, {0, 0, 0}}, {{0, 0, 0}, {0, nan, 0}}});
              }),
              HasSubstr("build_figure_tree: figures[1].b.y is nan"));
  EXPECT_THAT(text_of<InvalidShape>([&] {
                (void)build_figure_tree(std::vector<Aabb2>{{{0, 1}, {1, 0}}});
              }),
              HasSubstr("build_figure_tree: figures[0] is empty"));
  EXPECT_THAT(text_of<InvalidShape>([&] { (void)build_figure_tree(std::vector<Aabb2>{}, {.most_in_leaf = 0}); }),
              HasSubstr("build_figure_tree: options.most_in_leaf is 0"));
}

}  // namespace
}  // namespace plumb
