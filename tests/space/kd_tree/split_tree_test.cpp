// The k-d tree of figures: which leaf has which figure by the definition, and every question against each figure asked.
#include "plumb/space/kd_tree/split_tree.hpp"

#include <gmock/gmock.h>

#include "certify/sanitized.hpp"
#include "certify/statements/golden_statements.hpp"
#include "certify/statements/mutant_statements.hpp"
#include "certify/statements/promised_share.hpp"
#include "certify/statements/proved_statements.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/certify/judged_proofs.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/figure/aabb/aabb.hpp"
#include "plumb/predicates.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/space/kd_tree/split_range.hpp"
#include "plumb/space/kd_tree/split_ray.hpp"
#include "space/kd_tree/figure_sets.hpp"
#include "space/kd_tree/passed_by.hpp"

namespace plumb {
namespace {

using Numbers = std::vector<std::uint32_t>;

template <class Figure>
auto fitted(const Figure& f) {
  if constexpr (requires { f.min; }) {
    return f;
  } else {
    return fit_aabb(f);
  }
}
/// Leaf by leaf: the planes that bound it, and those that belong to it.
template <class Figure>
struct Cell {
  static constexpr std::size_t d = SplitTree<Figure>::dimension;
  std::array<double, d> low, high;
  std::array<bool, d> ends_before{};  // is `high` a plane, which is not of the cell?
  std::uint32_t leaf = 0, depth = 0;
};

/// Clipped by the box of all figures.
template <class Figure>
void add_cells(const SplitTree<Figure>& tree, std::size_t node, Cell<Figure> cell, std::vector<Cell<Figure>>& cells) {
  const SplitNode& n = tree.nodes[node];
  if (n.is_leaf()) {
    cell.leaf = n.link;
    cells.push_back(cell);
    return;
  }
  ++cell.depth;
  Cell<Figure> below = cell, above = cell;
  below.high[n.axis] = n.plane, below.ends_before[n.axis] = true;
  above.low[n.axis] = n.plane;
  add_cells(tree, node + 1, below, cells);
  add_cells(tree, n.link, above, cells);
}
template <class Figure>
std::vector<Cell<Figure>> cells_of(const SplitTree<Figure>& tree) {
  Cell<Figure> all;
  all.low.fill(std::numeric_limits<double>::max()), all.high.fill(-std::numeric_limits<double>::max());
  for (const Figure& f : tree.figures) {
    const auto box = fitted(f);
    const auto low = coordinates(box.min), high = coordinates(box.max);
    for (std::size_t a = 0; a < all.d; ++a) {
      all.low[a] = std::min(all.low[a], low[a]), all.high[a] = std::max(all.high[a], high[a]);
    }
  }
  std::vector<Cell<Figure>> cells;
  add_cells(tree, 0, all, cells);
  return cells;
}

template <class Figure>
typename SplitTree<Figure>::Box box_of(const Cell<Figure>& c) {
  if constexpr (Cell<Figure>::d == 2) {
    return {{c.low[0], c.low[1]}, {c.high[0], c.high[1]}};
  } else {
    return {{c.low[0], c.low[1], c.low[2]}, {c.high[0], c.high[1], c.high[2]}};
  }
}

/// Law 2.
template <class Figure>
bool belongs_to(const Figure& f, const Cell<Figure>& c) {
  const auto box = fitted(f);
  const auto low = coordinates(box.min), high = coordinates(box.max);
  bool all = true;
  for (std::size_t a = 0; a < c.d; ++a) {
    all = all && high[a] >= c.low[a] && (c.ends_before[a] ? low[a] < c.high[a] : low[a] <= c.high[a]);
  }
  return all && intersects(f, box_of(c));
}

struct Counts {
  std::size_t leaves = 0, places = 0, figures = 0, cut_off = 0, pairs = 0, touching = 0, hits = 0, equal_hits = 0;
};

template <class Figure>
void expect_leaves_as_defined(const SplitTree<Figure>& tree, Counts& counts) {
  const auto cells = cells_of(tree);
  ASSERT_EQ(cells.size(), tree.leaves());
  for (const Cell<Figure>& c : cells) {
    Numbers expected;
    for (std::uint32_t i = 0; i < tree.figures.size(); ++i) {
      if (belongs_to(tree.figures[i], c)) expected.push_back(i);
      if (intersects(fitted(tree.figures[i]), box_of(c)) && !intersects(tree.figures[i], box_of(c))) ++counts.cut_off;
    }
    const auto items = tree.items_in(c.leaf);
    ASSERT_EQ(Numbers(items.begin(), items.end()), expected) << "leaf " << c.leaf;
    ASSERT_LE(c.depth, 60u);
  }
  counts.leaves += tree.leaves(), counts.places += tree.items.size(), counts.figures += tree.figures.size();
}

template <class Figure>
void expect_pairs(const SplitTree<Figure>& tree, Counts& counts) {
  std::vector<BoxPair> meeting, overlapping;
  for (std::uint32_t i = 0; i < tree.figures.size(); ++i) {
    for (std::uint32_t k = i + 1; k < tree.figures.size(); ++k) {
      const Relation r = relate(tree.figures[i], tree.figures[k]);
      if (r != Relation::disjoint) meeting.push_back({i, k});
      if (r == Relation::overlapping) overlapping.push_back({i, k});
    }
  }
  auto found = overlapping_pairs(tree), without = overlapping_pairs(tree, {.touching = false});
  ASSERT_EQ(found, overlapping_pairs(tree, {.execution = Execution::serial}));
  std::ranges::sort(found), std::ranges::sort(without);
  ASSERT_EQ(found, meeting);
  ASSERT_EQ(without, overlapping);
  counts.pairs += meeting.size(), counts.touching += meeting.size() - overlapping.size();
}

template <class Figure, class Way>
void expect_first_hit(const SplitTree<Figure>& tree, const Way& way, Counts& counts) {
  if constexpr (ShotAtFigure<Figure>) {
    std::optional<RayParameter> least;
    std::uint32_t which = 0;
    std::size_t equal = 0;
    for (std::uint32_t i = 0; i < tree.figures.size(); ++i) {
      const auto t = first_hit_parameter(way, tree.figures[i]);
      if (!t) continue;
      if (least && *t == *least) ++equal;
      if (!least || *t < *least) least = t, which = i, equal = 0;
    }
    const auto found = first_hit(tree, way);
    ASSERT_EQ(found.has_value(), least.has_value());
    ASSERT_EQ(any_hit(tree, way), found.has_value());
    if (!found) return;
    ASSERT_EQ(found->index, which);
    ASSERT_EQ(found->hit, *first_hit(way, tree.figures[which]));
    ++counts.hits, counts.equal_hits += equal > 0 ? 1 : 0;
  }
}

template <class Figure>
class SplitTreeTest : public ::testing::Test {};
using Figures = ::testing::Types<Aabb2, Segment2, Triangle2, Aabb3, Segment3, Triangle3>;
TYPED_TEST_SUITE(SplitTreeTest, Figures);

TYPED_TEST(SplitTreeTest, AnswersAsEachFigureDoes) {
  Counts counts;
  std::size_t in_boxes = 0;
  for (std::uint64_t index = 0; index < battery::fitting(144u); ++index) {
    Entropy e(7361, index);
    const std::size_t kind = index % figure_sets::kinds;
    SCOPED_TRACE(testing::Message() << "start 7361 index " << index << ", " << figure_sets::name_of(kind));
    const auto set = figure_sets::figures<TypeParam>(kind, 1 + e.below(kind == figure_sets::kinds - 1 ? 60 : 14), e);
    const auto tree = build_split_tree(set.figures, {.most_in_leaf = static_cast<std::uint32_t>(1 + e.below(4))});
    ASSERT_NO_FATAL_FAILURE(expect_leaves_as_defined(tree, counts));
    ASSERT_NO_FATAL_FAILURE(expect_pairs(tree, counts));
    const auto place = [&] { return figure_sets::place(kind, set, e); };
    const auto p = place(), q = place();
    const auto box = figure_sets::spanned<typename SplitTree<TypeParam>::Box>({p, q, p});
    Numbers meeting, over;
    for (std::uint32_t i = 0; i < tree.figures.size(); ++i) {
      if (intersects(tree.figures[i], box)) meeting.push_back(i);
      if (relate(tree.figures[i], box) == Relation::overlapping) over.push_back(i);
    }
    ASSERT_EQ(in_box(tree, box), meeting);
    ASSERT_EQ(in_box(tree, box, {.touching = false}), over);
    in_boxes += meeting.size();
    const auto c = coordinates(q);
    const auto component = [&](std::size_t k) { return e.below(3) == 0 ? static_cast<double>(e.within(2)) : c[k]; };
    ASSERT_NO_FATAL_FAILURE(expect_first_hit(tree, typename SplitTree<TypeParam>::Segment{p, q}, counts));
    if constexpr (SplitTree<TypeParam>::dimension == 2) {
      ASSERT_NO_FATAL_FAILURE(expect_first_hit(tree, Ray2{p, {component(0), component(1)}}, counts));
    } else {
      ASSERT_NO_FATAL_FAILURE(expect_first_hit(tree, Ray3{p, {component(0), component(1), component(2)}}, counts));
    }
    // The leaf of a place is on every way that begins there.
    const auto on_the_way = cells_along(tree, typename SplitTree<TypeParam>::Segment{p, q}, WalkedCells::half_open);
    ASSERT_EQ(on_the_way.front(), locate(tree, p));
    ASSERT_EQ(on_the_way.back(), locate(tree, q));
  }
  EXPECT_GT(counts.leaves, battery::fitting(300u));
  EXPECT_GT(counts.places, counts.figures);
  EXPECT_GT(in_boxes, battery::fitting(200u));
  EXPECT_GT(counts.pairs, battery::fitting(1000u));
  if (battery::reaches_rare) {
    EXPECT_GT(counts.touching, 100u);
    if (ShotAtFigure<TypeParam>) {
      EXPECT_GT(counts.hits, 60u);
      EXPECT_GT(counts.equal_hits, 5u);
    }
    if (!requires(const TypeParam& f) { f.min; }) {
      EXPECT_GT(counts.cut_off, 30u);
    }
  }
}

template <class Figure>
bool are_alike(const SplitTree<Figure>& a, const SplitTree<Figure>& b) {
  return a.nodes == b.nodes && a.first == b.first && a.items == b.items;
}

TEST(ASplitTree, IsTheSameOnEveryNumberOfThreads) {
  Entropy e(7362, 0);
  std::vector<Triangle3> all;
  for (std::size_t i = 0; i < battery::fitting(10'000u); ++i) {
    const auto near = [&](double x) { return x + static_cast<double>(e.below(1000)) * 0x1p-14; };
    const double x = static_cast<double>(e.below(4096)) * 0x1p-12, y = static_cast<double>(e.below(4096)) * 0x1p-12,
                 z = static_cast<double>(e.below(4096)) * 0x1p-12;
    all.push_back({{x, y, z}, {near(x), near(y), near(z)}, {near(x), near(y), near(z)}});
  }
  const auto serial = build_split_tree(all, {.execution = Execution::serial});
  const auto pairs = overlapping_pairs(serial, {.execution = Execution::serial});
  EXPECT_GT(serial.leaves(), all.size() / 8);
  EXPECT_LE(serial.items.size(), 8 * all.size());
  EXPECT_GT(pairs.size(), battery::reaches_rare ? 1000u : 10u);
  for (const std::size_t threads : {1u, 2u}) {
    const ThreadLimit control(threads);
    const auto tree = build_split_tree(all);
    EXPECT_TRUE(are_alike(tree, serial));
    EXPECT_EQ(overlapping_pairs(tree), pairs);
  }
  const auto tight = build_split_tree(all, {.most_references = 1.25});
  EXPECT_LE(tight.items.size(), all.size() + all.size() / 4);
  EXPECT_EQ(overlapping_pairs(tight).size(), pairs.size());
}

TEST(ASplitTree, HoldsManyEqualFigures) {
  const std::size_t n = battery::fitting(1'000'000u);
  const auto equal = build_split_tree(std::vector<Aabb2>(n, Aabb2{{0.1, 0.2}, {0.3, 0.7}}));
  EXPECT_EQ(in_box(equal, {{0.3, 0.7}, {1, 1}}).size(), n);
  EXPECT_TRUE(in_box(equal, {{std::nextafter(0.3, 1), 0}, {1, 1}}).empty());
  EXPECT_EQ(first_hit(equal, Ray2{{0, 0.5}, {1, 0}})->index, 0u);
}

TEST(ASplitTree, StopsAtTheFirstHitAndNotBefore) {
  // Of walls a unit apart the ray meets the first two within a rounding of one another.
  std::vector<Triangle3> walls;
  for (int i = 0; i < 64; ++i) {
    const double x = i;
    walls.push_back({{x, -8, -8}, {x, 16, -8}, {x, -8, 16}});
  }
  walls.push_back(
      {{std::nextafter(1.0, 0), -8, -8}, {std::nextafter(1.0, 0), 16, -8}, {std::nextafter(1.0, 0), -8, 16}});
  const auto tree = build_split_tree(walls, {.most_in_leaf = 1});
  EXPECT_EQ(first_hit(tree, Ray3{{0.5, 0, 0}, {0x1p60, 0, 0}})->index, 64u);
  EXPECT_EQ(first_hit(tree, Ray3{{1.5, 0, 0}, {-3, 0, 0}})->index, 1u);
  EXPECT_EQ(first_hit(tree, Segment3{{-5, 0.5, 0.5}, {-1e-300, 0.5, 0.5}}), std::nullopt);
  EXPECT_EQ(first_hit(tree, Segment3{{-5, 0.5, 0.5}, {0, 0.5, 0.5}})->index, 0u);
}

/// Of corners that are all looked at.
template <bool is_segment>
void expect_bounds_of_side(const char* name) {
  const space::kd::SideOfCorners<is_segment> side;
  const std::vector<std::string> bounds = judged_bounds(side, 0.0, 0.0, 4.0, 1.0, 1.0, 3.0, 2.0, 5.0, 3.0, 4.0);
  expect_golden(name, bounds);
  expect_proved(bounds, judged_proofs(name, side, 0.0, 0.0, 4.0, 1.0, 1.0, 3.0, 2.0, 5.0, 3.0, 4.0));
}
TEST(ASplitTree, SidesOfCornersAreAsRecordedAndProved) {
  expect_bounds_of_side<false>("corners_beside_ray");
  expect_bounds_of_side<true>("corners_beside_segment");
}

TEST(ASplitTree, SidesOfCornersAreToldInPromisedShare) {
  const auto draw = [](const auto& ask, const std::array<double, 10>& x) {
    ask(x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8], x[9]);
  };
  expect_share<10>("corners_beside_ray", space::kd::SideOfCorners<false>{}, draw, 2);
  expect_share<10>("corners_beside_segment", space::kd::SideOfCorners<true>{}, draw, 2);
}

template <bool is_segment>
std::string unnoticed() {
  using Points = std::array<Point2, 5>;  // a line's point and direction, or its ends; three corners
  return mutants::unnoticed(
      [](mutants::Draw& d) {
        Points all{};
        for (Point2& p : all) p = {d.number(), d.number()};
        return all;
      },
      [](const Points& x) {
        return mutants::told<mutants::World>(space::kd::SideOfCorners<is_segment>{}, x[0].x, x[0].y, x[1].x, x[1].y,
                                             x[2].x, x[2].y, x[3].x, x[3].y, x[4].x, x[4].y);
      },
      [](const Points& x) {
        const Point2 to = is_segment ? x[1] : Point2{x[0].x + x[1].x, x[0].y + x[1].y};
        const Sign first = orient2d(x[0], to, x[2]);
        return orient2d(x[0], to, x[3]) == first && orient2d(x[0], to, x[4]) == first ? first : Sign::zero;
      },
      0, 5000);
}
TEST(ASplitTree, MutantsOfSidesAreNoticed) {
  mutants::expect_noticed("corners_beside_ray", unnoticed<false>());
  mutants::expect_noticed("corners_beside_segment", unnoticed<true>());
}

TEST(ASplitTree, NamesWhatIsRefused) {
  using ::testing::HasSubstr;
  const auto none = build_split_tree(std::vector<Triangle2>{});
  EXPECT_EQ(none.leaves(), 0u);
  EXPECT_TRUE(in_box(none, {{0, 0}, {1, 1}}).empty());
  EXPECT_TRUE(overlapping_pairs(none).empty());
  EXPECT_TRUE(cells_along(none, Segment2{{0, 0}, {1, 1}}).empty());
  EXPECT_EQ(first_hit(none, Ray2{{0, 0}, {1, 1}}), std::nullopt);
  const double nan = std::nan("");
  const std::vector<Aabb2> one{{{0, 0}, {1, 1}}};
  const auto tree = build_split_tree(one);
  EXPECT_TRUE(in_box(tree, {{1, 1}, {0, 0}}).empty());
  EXPECT_THAT(text_of<NonFinite>([&] {
                (void)in_box(tree, {{0, 0}, {1, nan}});
              }),
              HasSubstr("in_box: box.max.y is nan"));
  EXPECT_THAT(text_of<NonFinite>([&] { (void)locate(tree, {nan, 0}); }), HasSubstr("locate: p.x is nan"));
  EXPECT_THAT(text_of<NonFinite>([&] {
                (void)first_hit(tree, Ray2{{0, 0}, {nan, 0}});
              }),
              HasSubstr("first_hit: ray.direction.x is nan"));
  EXPECT_THAT(text_of<NonFinite>([&] {
                (void)build_split_tree(std::vector<Aabb2>{{{0, nan}, {1, 0}}});
              }),
              HasSubstr("build_split_tree: figures[0].min.y is nan"));
  EXPECT_THAT(text_of<InvalidShape>([&] { (void)build_split_tree(one, {.most_in_leaf = 0}); }),
              HasSubstr("most_in_leaf"));
  EXPECT_THAT(text_of<InvalidShape>([&] { (void)build_split_tree(one, {.most_depth = 61}); }),
              HasSubstr("options.most_depth is 61, but it must be at most 60"));
  EXPECT_THAT(text_of<InvalidShape>([&] { (void)build_split_tree(one, {.most_references = 0.5}); }),
              HasSubstr("most_references"));
}

}  // namespace
}  // namespace plumb
