// Are the leaves of a walk those that a line touches in rational arithmetic, and in their order?
#include "plumb/space/octree/cell_walk.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <optional>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/arith/rational.hpp"
#include "plumb/degenerate/ulps.hpp"
#include "plumb/space/octree/point_octree.hpp"
#include "space/octree/scenes.hpp"

namespace plumb {
namespace {

/// A line's parameters in a cell: an interval each of whose ends may be open.
struct Interval {
  Rational from, to;
  bool from_open = false, to_open = false, has_end = true;

  void raise(const Rational& t, bool open) {
    if (t > from) from = t, from_open = open;
    if (t == from) from_open |= open;
  }
  void lower(const Rational& t, bool open) {
    if (!has_end || t < to) to = t, to_open = open, has_end = true;
    if (t == to) to_open |= open;
  }
  [[nodiscard]] bool empty() const { return has_end && (from > to || (from == to && (from_open || to_open))); }
};

template <std::size_t D>
struct Way {
  std::array<double, D> from;
  std::array<Rational, D> along;
  bool ends;
};
template <std::size_t D>
Way<D> way_of(const typename CellKinds<D>::Segment& s) {
  Way<D> way{coordinates(s.a), {}, true};
  for (std::size_t k = 0; k < D; ++k) way.along[k] = Rational(coordinates(s.b)[k]) - Rational(way.from[k]);
  return way;
}
template <std::size_t D>
Way<D> way_of(const typename CellKinds<D>::Ray& r) {
  Way<D> way{coordinates(r.origin), {}, false};
  for (std::size_t k = 0; k < D; ++k) way.along[k] = Rational(coordinates(r.direction)[k]);
  return way;
}

template <std::size_t D>
std::optional<Interval> in_cell(const Way<D>& way, const typename CellKinds<D>::Box& cell, WalkedCells walk) {
  const bool half_open = walk == WalkedCells::half_open;
  Interval t{Rational(0), Rational(1), false, false, way.ends};
  const auto low = coordinates(cell.min), high = coordinates(cell.max);
  for (std::size_t k = 0; k < D; ++k) {
    const double x = way.from[k];
    if (low[k] == high[k]) return std::nullopt;  // both infinite
    const int side = static_cast<int>(way.along[k].sign());
    if (side == 0) {
      if (x < low[k] || x > high[k] || (half_open && x == high[k])) return std::nullopt;
      continue;
    }
    const auto parameter = [&](double border) { return (Rational(border) - Rational(x)) / way.along[k]; };
    if (!std::isinf(low[k])) {
      side > 0 ? t.raise(parameter(low[k]), false) : t.lower(parameter(low[k]), false);
    }
    if (!std::isinf(high[k])) {
      side > 0 ? t.lower(parameter(high[k]), half_open) : t.raise(parameter(high[k]), half_open);
    }
  }
  if (t.empty()) return std::nullopt;
  return t;
}

/// Their order by where they are entered, of one place by Morton order: that of the codes as binary fractions.
template <std::size_t D>
bool is_before(const CellNode& a, const Interval& x, const CellNode& b, const Interval& y) {
  if (x.from != y.from) return x.from < y.from;
  if (x.from_open != y.from_open) return y.from_open;
  const auto fraction = [](const CellNode& n) {
    const unsigned level = level_of<D>(n.code);
    return (n.code ^ std::uint64_t{1} << D * level) << D * (CellFrame<D>::levels - level);
  };
  return fraction(a) < fraction(b);
}

struct Seen {
  std::size_t leaves = 0, corners = 0, missed = 0, walks = 0;
};

template <std::size_t D, class Line>
void walk_is_that_of_rationals(const CellTree<D>& tree, const Line& line, const std::string& text, Seen& seen) {
  const Way<D> way = way_of<D>(line);
  for (const WalkedCells walk : {WalkedCells::half_open, WalkedCells::closed}) {
    struct Met {
      std::uint32_t leaf;
      Interval at;
    };
    std::vector<Met> met;
    for (std::uint32_t node = 0; node < tree.nodes.size(); ++node) {
      if (!tree.nodes[node].is_leaf()) continue;
      if (const auto at = in_cell<D>(way, box_of(tree, node), walk)) met.push_back({node, *at});
    }
    std::sort(met.begin(), met.end(), [&](const Met& a, const Met& b) {
      return is_before<D>(tree.nodes[a.leaf], a.at, tree.nodes[b.leaf], b.at);
    });
    std::vector<std::uint32_t> expected;
    for (const Met& m : met) {
      expected.push_back(m.leaf);
      seen.corners += m.at.has_end && m.at.from == m.at.to ? 1 : 0;
    }
    EXPECT_EQ(cells_along(tree, line, walk), expected)
        << text << (walk == WalkedCells::closed ? " closed" : " half open");
    seen.leaves += expected.size();
    seen.missed += expected.empty() ? 1 : 0;
    ++seen.walks;
    if (walk == WalkedCells::closed) continue;
    // Each place in one cell: one ends where the next begins.
    for (std::size_t i = 1; i < met.size(); ++i) {
      EXPECT_TRUE(met[i - 1].at.has_end && met[i - 1].at.to == met[i].at.from &&
                  met[i - 1].at.to_open != met[i].at.from_open)
          << text;
    }
  }
}

template <class Dimension>
class Walks : public ::testing::Test {};
using Dimensions = ::testing::Types<std::integral_constant<std::size_t, 2>, std::integral_constant<std::size_t, 3>>;
TYPED_TEST_SUITE(Walks, Dimensions);

template <std::size_t D>
auto tree_of(scenes::Family family, std::size_t n, Entropy& e) {
  const auto points = scenes::points_of<D>(family, n, e);
  if constexpr (D == 2) {
    return build_quadtree(points, {.most_in_leaf = 1, .most_depth = static_cast<std::uint32_t>(1 + e.below(9))}).cells;
  } else {
    return build_octree(points, {.most_in_leaf = 1, .most_depth = static_cast<std::uint32_t>(1 + e.below(5))}).cells;
  }
}

/// A place on borders, or up to an ulp beside them: what walks are wrong at.
template <std::size_t D>
typename CellKinds<D>::Point place_at_borders(const CellTree<D>& tree, scenes::Family family, Entropy& e) {
  const auto leaf = static_cast<std::uint32_t>(e.below(tree.nodes.size()));
  const auto cell = box_of(tree, leaf);
  std::array<double, D> x;
  const auto low = coordinates(cell.min), high = coordinates(cell.max),
             other = coordinates(scenes::point_of<D>(family, e));
  for (std::size_t k = 0; k < D; ++k) {
    const double border = e.coin() ? low[k] : high[k];
    x[k] = e.below(6) == 0 || std::isinf(border) ? other[k] : border;
    if (e.below(4) == 0) x[k] = moved_by_ulps(x[k], e.within(1));
  }
  if constexpr (D == 2) {
    return {x[0], x[1]};
  } else {
    return {x[0], x[1], x[2]};
  }
}

TYPED_TEST(Walks, SegmentsVisitWhatTheyTouchInOrder) {
  constexpr std::size_t D = TypeParam::value;
  Seen seen;
  scenes::on_scenes(
      781 + D, battery::sanitized ? 2 : 10, [&](scenes::Family family, Entropy& e, const std::string& text) {
        const auto tree = tree_of<D>(family, 1 + e.below(12), e);
        for (int k = 0; k < 4; ++k) {
          const auto a = place_at_borders(tree, family, e), b = e.below(8) == 0 ? a : place_at_borders(tree, family, e);
          walk_is_that_of_rationals(tree, typename CellKinds<D>::Segment{a, b}, text, seen);
        }
      });
  EXPECT_GT(seen.leaves, 5 * seen.walks / 4);
  EXPECT_GT(seen.corners, seen.walks / 4);
}

TYPED_TEST(Walks, RaysVisitWhatTheyTouchInOrder) {
  constexpr std::size_t D = TypeParam::value;
  Seen seen;
  scenes::on_scenes(791 + D, battery::sanitized ? 2 : 10,
                    [&](scenes::Family family, Entropy& e, const std::string& text) {
                      const auto tree = tree_of<D>(family, 1 + e.below(12), e);
                      for (int k = 0; k < 4; ++k) {
                        typename CellKinds<D>::Ray ray{};
                        ray.origin = place_at_borders(tree, family, e);
                        // Diagonals go through corners; directions of zeros along faces and edges.
                        const auto number = [&] {
                          return e.below(5) == 0 ? extreme_coordinate(e) : static_cast<double>(e.within(2));
                        };
                        ray.direction.x = number(), ray.direction.y = number();
                        if constexpr (D == 3) ray.direction.z = number();
                        walk_is_that_of_rationals(tree, ray, text, seen);
                      }
                    });
  EXPECT_GT(seen.leaves, seen.walks);
  EXPECT_GT(seen.corners, seen.walks / 20);
  EXPECT_GT(seen.missed, 0u);
}

// Through the corner that eight cells have in common: one of them in half-open cells beside those that it passes.
TEST(CellWalk, TheDiagonalOfEightCells) {
  const PointOctree tree = build_octree(std::vector<Point3>{{0, 0, 0}, {1, 1, 1}}, {.most_in_leaf = 1});
  ASSERT_EQ(tree.cells.nodes.size(), 9u);
  const Aabb3 middle = box_of(tree.cells, 8);
  const Point3 c = middle.min, a{c.x - 0.25, c.y - 0.25, c.z - 0.25}, b{c.x + 0.25, c.y + 0.25, c.z + 0.25};
  using Leaves = std::vector<std::uint32_t>;
  EXPECT_EQ(cells_along(tree.cells, Segment3{a, b}, WalkedCells::half_open), (Leaves{1, 8}));
  EXPECT_EQ(cells_along(tree.cells, Segment3{b, a}, WalkedCells::half_open), (Leaves{8, 1}));
  EXPECT_EQ(cells_along(tree.cells, Segment3{a, b}, WalkedCells::closed), (Leaves{1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(cells_along(tree.cells, Segment3{c, c}, WalkedCells::half_open), (Leaves{8}));
  EXPECT_EQ(cells_along(tree.cells, Segment3{c, c}, WalkedCells::closed).size(), 8u);
  // An ulp beside it the cells between are met.
  const Point3 d{c.x + 0.25, c.y + 0.25, std::nextafter(c.z + 0.25, 2)};
  EXPECT_EQ(cells_along(tree.cells, Segment3{a, d}, WalkedCells::closed), (Leaves{1, 5, 6, 7, 8}));
  EXPECT_EQ(cells_along(tree.cells, Segment3{a, d}, WalkedCells::half_open), (Leaves{1, 5, 8}));
}

TEST(CellWalk, RefusesWhatIsNoNumberAndWalksNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Octree none;
  EXPECT_THAT(text_of<NonFinite>([&] {
                (void)cells_along(none, Segment3{{0, 0, 0}, {0, nan, 0}}, WalkedCells::closed);
              }),
              ::testing::HasSubstr("CellWalker: segment.b.y is nan"));
  EXPECT_THAT(text_of<NonFinite>([&] {
                (void)cells_along(none, Ray3{{nan, 0, 0}, {0, 1, 0}}, WalkedCells::closed);
              }),
              ::testing::HasSubstr("CellWalker: ray.origin.x is nan"));
  EXPECT_TRUE(cells_along(none, Ray3{{0, 0, 0}, {0, 1, 0}}, WalkedCells::closed).empty());
}

}  // namespace
}  // namespace plumb
