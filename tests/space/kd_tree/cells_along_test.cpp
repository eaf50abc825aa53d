// The cells along rays and segments against each cell's interval of parameters in rational numbers: paths through
// planes, along them, through their corners, and off by one ulp.
#include "plumb/space/kd_tree/cells_along.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <optional>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/arith/rational.hpp"
#include "plumb/space/kd_tree/split_ray.hpp"
#include "space/kd_tree/figure_sets.hpp"

namespace plumb {
namespace {

using point_sets::Kind;

/// From where on a path is in a cell, if it is.
struct Stay {
  Rational from{0.0};
  bool from_open = false;
  std::optional<Rational> to;  // none: without end
  bool to_open = false;
  bool is_some = true;
};

void narrow(Stay& stay, const Rational& t, bool open, bool is_start) {
  if (is_start) {
    if (stay.from < t) {
      stay.from = t, stay.from_open = open;
    } else if (stay.from == t) {
      stay.from_open = stay.from_open || open;
    }
  } else if (!stay.to || t < *stay.to) {
    stay.to = t, stay.to_open = open;
  } else if (*stay.to == t) {
    stay.to_open = stay.to_open || open;
  }
}

/// One side of a plane, of which the upper one has the plane.
struct Side {
  std::size_t axis;
  double plane;
  bool is_upper;
};
using Sides = std::vector<Side>;  // of which a cell is what they have in common

template <class Point>
std::vector<Sides> cells_of(const KdTree<Point>& tree) {
  std::vector<Sides> cells(tree.leaves());
  for (std::size_t leaf = 0; leaf < tree.leaves(); ++leaf) {
    for (std::size_t node = leaf + tree.leaves() - 1; node != 0; node = (node - 1) / 2) {
      const std::size_t parent = (node - 1) / 2;
      cells[leaf].push_back({tree.axes[parent], tree.planes[parent], node % 2 == 0});
    }
  }
  return cells;
}
template <class Figure>
std::vector<Sides> cells_of(const SplitTree<Figure>& tree) {
  std::vector<Sides> below(tree.nodes.size()), cells(tree.leaves());
  for (std::size_t node = 0; node < tree.nodes.size(); ++node) {  // parents come before their children
    const SplitNode& n = tree.nodes[node];
    if (n.is_leaf()) {
      cells[n.link] = below[node];
      continue;
    }
    for (const bool is_upper : {false, true}) {
      Sides& child = below[is_upper ? n.link : node + 1] = below[node];
      child.push_back({n.axis, n.plane, is_upper});
    }
  }
  return cells;
}

/// By its definition: the parameters at which origin + t way is in a cell.
template <std::size_t d>
Stay stay_in(const Sides& cell, const std::array<Rational, d>& origin, const std::array<Rational, d>& way, bool is_ray,
             WalkedCells cells) {
  Stay stay;
  if (!is_ray) stay.to = Rational(1.0);
  for (const auto& [axis, plane, is_upper] : cell) {
    const bool leaves_plane_out = cells == WalkedCells::half_open && !is_upper;
    const Rational left = Rational(plane) - origin[axis];
    if (way[axis].sign() == Sign::zero) {
      const int side = -static_cast<int>(left.sign());  // of the origin from the plane
      stay.is_some = stay.is_some && (side == 0 ? !leaves_plane_out : is_upper == (side > 0));
    } else {
      narrow(stay, left / way[axis], leaves_plane_out, is_upper == (way[axis].sign() == Sign::positive));
    }
  }
  if (stay.to && (*stay.to < stay.from || (*stay.to == stay.from && (stay.from_open || stay.to_open))))
    stay.is_some = false;
  return stay;
}

struct Counts {
  std::size_t cells = 0, touched = 0, at_once = 0;
};

template <class Tree, class Path>
void expect_as_defined(const Tree& tree, const Path& path, Counts& counts) {
  constexpr std::size_t d = Tree::dimension;
  constexpr bool is_ray = requires { path.direction; };
  std::array<Rational, d> origin, way;
  if constexpr (is_ray) {
    const auto o = coordinates(path.origin), v = coordinates(path.direction);
    for (std::size_t k = 0; k < d; ++k) origin[k] = Rational(o[k]), way[k] = Rational(v[k]);
  } else {
    const auto a = coordinates(path.a), b = coordinates(path.b);
    for (std::size_t k = 0; k < d; ++k) origin[k] = Rational(a[k]), way[k] = Rational(b[k]) - Rational(a[k]);
  }
  const std::vector<Sides> all = cells_of(tree);
  for (const WalkedCells cells : {WalkedCells::closed, WalkedCells::half_open}) {
    const std::vector<std::uint32_t> found = cells_along(tree, path, cells);
    std::vector<bool> is_found(tree.leaves());
    std::optional<Stay> before;
    for (const std::uint32_t leaf : found) {
      ASSERT_FALSE(is_found[leaf]) << "twice";
      is_found[leaf] = true;
      const Stay stay = stay_in(all[leaf], origin, way, is_ray, cells);
      if (before) {
        ASSERT_TRUE(before->from < stay.from || (before->from == stay.from &&
                                                 (cells == WalkedCells::closed || before->from_open <= stay.from_open)))
            << "leaf " << leaf << " is entered before the one ahead of it";
        counts.at_once += before->from == stay.from ? 1 : 0;
      }
      counts.touched += stay.to && *stay.to == stay.from ? 1 : 0;
      before = stay;
    }
    for (std::size_t leaf = 0; leaf < tree.leaves(); ++leaf) {
      ASSERT_EQ(is_found[leaf], stay_in(all[leaf], origin, way, is_ray, cells).is_some)
          << "leaf " << leaf << (cells == WalkedCells::closed ? ", closed" : ", half open");
    }
    counts.cells += found.size();
  }
}

/// A coordinate on a plane of the tree, or one ulp off it, or any.
template <class Tree>
double aimed(const Tree& tree, std::size_t axis, double any, Entropy& e) {
  const std::vector<Sides> cells = cells_of(tree);
  const Sides& cell = cells[e.below(cells.size())];
  if (cell.empty()) return any;
  const Side& side = cell[e.below(cell.size())];
  if (side.axis != axis) return any;
  switch (e.below(4)) {
    case 0:
      return std::nextafter(side.plane, 1e300);
    case 1:
      return std::nextafter(side.plane, -1e300);
    default:
      return side.plane;
  }
}

template <class Point>
class CellsAlong : public ::testing::Test {};
using PointTypes = ::testing::Types<Point2, Point3>;
TYPED_TEST_SUITE(CellsAlong, PointTypes);

TYPED_TEST(CellsAlong, AreThoseOfTheDefinitionInOrder) {
  constexpr bool in_plane = std::is_same_v<TypeParam, Point2>;
  using Segment = std::conditional_t<in_plane, Segment2, Segment3>;
  using Ray = std::conditional_t<in_plane, Ray2, Ray3>;
  Counts counts;
  for (std::uint64_t index = 0; index < battery::fitting(540u); ++index) {
    Entropy e(7331, index);
    const auto kind = static_cast<Kind>(index % point_sets::kinds);
    SCOPED_TRACE(testing::Message() << "start 7331 index " << index);
    const auto all = point_sets::points<TypeParam>(kind, 1 + e.below(24), e);
    const auto tree = build_kd_tree(all, {.most_in_leaf = static_cast<std::uint32_t>(1 + e.below(3))});
    const auto place = [&] {
      TypeParam p = point_sets::query(kind, all, e);
      p.x = aimed(tree, 0, p.x, e), p.y = aimed(tree, 1, p.y, e);
      if constexpr (!in_plane) p.z = aimed(tree, 2, p.z, e);
      return p;
    };
    const TypeParam a = place(), b = place();
    expect_as_defined(tree, Segment{a, b}, counts);
    const auto c = coordinates(b);
    const auto component = [&](std::size_t k) { return e.below(3) == 0 ? static_cast<double>(e.within(2)) : c[k]; };
    if constexpr (in_plane) {
      expect_as_defined(tree, Ray{a, {component(0), component(1)}}, counts);
    } else {
      expect_as_defined(tree, Ray{a, {component(0), component(1), component(2)}}, counts);
    }
    if (this->HasFatalFailure()) return;
  }
  EXPECT_GT(counts.cells, battery::fitting(5000u));
  EXPECT_GT(counts.touched, battery::fitting(500u));
  EXPECT_GT(counts.at_once, battery::fitting(1000u));
}

TEST(CellsAlongFigures, AreThoseOfTheDefinitionInOrder) {
  Counts counts;
  for (std::uint64_t index = 0; index < battery::fitting(240u); ++index) {
    Entropy e(7332, index);
    const std::size_t kind = index % figure_sets::kinds;
    SCOPED_TRACE(testing::Message() << "start 7332 index " << index << ", " << figure_sets::name_of(kind));
    const auto set = figure_sets::figures<Segment3>(kind, 1 + e.below(30), e);
    const auto tree = build_split_tree(set.figures, {.most_in_leaf = static_cast<std::uint32_t>(1 + e.below(3))});
    const auto place = [&] {
      const Point3 p = figure_sets::place(kind, set, e);
      return Point3{aimed(tree, 0, p.x, e), aimed(tree, 1, p.y, e), aimed(tree, 2, p.z, e)};
    };
    const Point3 a = place(), b = place();
    expect_as_defined(tree, Segment3{a, b}, counts);
    expect_as_defined(tree, Ray3{a, {b.x, e.coin() ? b.y : 0.0, e.coin() ? b.z : 1.0}}, counts);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(counts.cells, battery::fitting(1500u));
  EXPECT_GT(counts.touched, battery::fitting(100u));
  EXPECT_GT(counts.at_once, battery::fitting(200u));
}

// Four points whose planes cross at (0, 0): the diagonal goes through the corner.
TEST(CellsAlongACorner, OneUlpDecides) {
  const KdTree2 tree = build_kd_tree(std::vector<Point2>{{-2, -1}, {-2, 0}, {0, -1}, {0, 0}}, {.most_in_leaf = 1});
  ASSERT_EQ(tree.planes, (std::vector<double>{0, 0, 0}));
  const auto count = [&](const Segment2& s, WalkedCells cells) { return cells_along(tree, s, cells).size(); };
  EXPECT_EQ(count({{-1, -1}, {1, 1}}, WalkedCells::closed), 4u);
  EXPECT_EQ(count({{-1, -1}, {1, 1}}, WalkedCells::half_open), 2u);
  EXPECT_EQ(count({{-1, -1}, {1, std::nextafter(1, 2)}}, WalkedCells::closed), 3u);
  EXPECT_EQ(count({{-1, -1}, {1, std::nextafter(1, 0)}}, WalkedCells::half_open), 3u);
  EXPECT_EQ(count({{-1, 1}, {1, -1}}, WalkedCells::half_open), 3u);
  EXPECT_EQ(count({{-1, 0}, {1, 0}}, WalkedCells::closed), 4u);
  EXPECT_EQ(count({{-1, 0}, {1, 0}}, WalkedCells::half_open), 2u);
  EXPECT_EQ(count({{0, 0}, {0, 0}}, WalkedCells::half_open), 1u);
}

TEST(CellsAlongARay, NamesWhatIsRefused) {
  const KdTree3 none = build_kd_tree(std::vector<Point3>{});
  EXPECT_EQ(cells_along(none, Segment3{{0, 0, 0}, {1, 1, 1}}), std::vector<std::uint32_t>{0});
  EXPECT_THAT(text_of<NonFinite>([&] {
                (void)cells_along(none, Ray3{{0, 0, 0}, {0, std::nan(""), 0}});
              }),
              ::testing::HasSubstr("cells_along: ray.direction.y is nan"));
}

}  // namespace
}  // namespace plumb
