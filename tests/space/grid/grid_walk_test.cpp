// Does a walk visit exactly the cells that the ray touches?  Each cell judged by itself, in rational numbers.
#include "plumb/space/grid/grid_walk.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/arith/rational.hpp"
#include "plumb/degenerate/entropy.hpp"

namespace plumb {
namespace {

using ::testing::HasSubstr;

template <std::size_t n>
struct Case {
  std::array<double, n> origin, size, from, to;  // of a ray, to is its direction
  bool is_segment;
  CellRange<n> range;
};

template <std::size_t n>
CellGridOf<n> grid_of(const Case<n>& c) {
  if constexpr (n == 2) return {{c.origin[0], c.origin[1]}, {c.size[0], c.size[1]}};
  if constexpr (n == 3) return {{c.origin[0], c.origin[1], c.origin[2]}, {c.size[0], c.size[1], c.size[2]}};
}
template <std::size_t n>
GridWalk<n> walk_of(const Case<n>& c, WalkedCells cells) {
  const GridWalkOptions<n> options{cells, c.range};
  if constexpr (n == 2) {
    const Point2 from{c.from[0], c.from[1]};
    if (c.is_segment) return {grid_of(c), Segment2{from, {c.to[0], c.to[1]}}, options};
    return {grid_of(c), Ray2{from, {c.to[0], c.to[1]}}, options};
  } else {
    const Point3 from{c.from[0], c.from[1], c.from[2]};
    if (c.is_segment) return {grid_of(c), Segment3{from, {c.to[0], c.to[1], c.to[2]}}, options};
    return {grid_of(c), Ray3{from, {c.to[0], c.to[1], c.to[2]}}, options};
  }
}

template <std::size_t n>
std::string text(const Case<n>& c) {
  std::ostringstream out;
  out << std::hexfloat << (c.is_segment ? "segment" : "ray");
  for (const auto& part : {c.origin, c.size, c.from, c.to}) {
    for (const double x : part) out << " " << x;
    out << ";";
  }
  return out.str();
}

/// The parameters at which a line is in a cell: from one on, up to another, each included or not; no end where none is.
struct Stay {
  std::optional<Rational> from, to;
  bool has_from = true, has_to = true, is_empty = false;

  void begin_at(const Rational& t, bool included) {
    if (from && (*from > t || (*from == t && !has_from))) return;
    from = t, has_from = included;
  }
  void end_at(const Rational& t, bool included) {
    if (to && (*to < t || (*to == t && !has_to))) return;
    to = t, has_to = included;
  }
  [[nodiscard]] bool is_somewhere() const {
    return !is_empty && (!from || !to || *from < *to || (*from == *to && has_from && has_to));
  }
};

/// Of one cell, as its walls say.
template <std::size_t n>
Stay stay_in(const Case<n>& c, const std::array<std::int64_t, n>& cell, WalkedCells cells) {
  Stay stay;
  stay.begin_at(Rational(0), true);
  if (c.is_segment) stay.end_at(Rational(1), true);
  const bool closed = cells == WalkedCells::closed;
  for (std::size_t a = 0; a < n; ++a) {
    const Rational size(c.size[a]), from = Rational(c.from[a]) - Rational(c.origin[a]);
    const Rational lower = Rational(cell[a]) * size - from, upper = lower + size;  // as the line sees them
    const Rational way = c.is_segment ? Rational(c.to[a]) - Rational(c.from[a]) : Rational(c.to[a]);
    if (way.sign() == Sign::zero) {
      stay.is_empty = stay.is_empty || lower.sign() == Sign::positive || upper.sign() == Sign::negative ||
                      (!closed && upper.sign() == Sign::zero);
    } else if (way.sign() == Sign::positive) {
      stay.begin_at(lower / way, true);
      stay.end_at(upper / way, closed);
    } else {
      stay.begin_at(upper / way, closed);
      stay.end_at(lower / way, true);
    }
  }
  return stay;
}

template <std::size_t n>
std::vector<std::array<std::int64_t, n>> cells_in(const CellRange<n>& range) {
  std::vector<std::array<std::int64_t, n>> all;
  std::array<std::int64_t, n> cell = range.first;
  for (std::size_t a = 0; a < n;) {
    all.push_back(cell);
    for (a = 0; a < n && cell[a] == range.last[a]; ++a) cell[a] = range.first[a];
    if (a < n) ++cell[a];
  }
  return all;
}

struct Seen {
  int cases = 0, visited = 0, empty = 0, at_once = 0, only_touched = 0;
};

template <std::size_t n>
void expect_exact(const Case<n>& c, WalkedCells cells, Seen& seen) {
  std::map<std::array<std::int64_t, n>, Rational> expected;
  for (const auto& cell : cells_in(c.range)) {
    const Stay stay = stay_in(c, cell, cells);
    if (!stay.is_somewhere()) continue;
    expected.emplace(cell, *stay.from);
    seen.only_touched += stay.to && *stay.from == *stay.to ? 1 : 0;
  }
  ++seen.cases;
  seen.empty += expected.empty() ? 1 : 0;
  GridWalk<n> walk = walk_of(c, cells);
  std::optional<Rational> before;
  std::size_t visited = 0;
  while (walk.next()) {
    ASSERT_LT(visited, expected.size()) << text(c);
    const auto found = expected.find(walk.cell());
    ASSERT_NE(found, expected.end()) << text(c) << " cell " << ::testing::PrintToString(walk.cell());
    if (before) {
      ASSERT_LE(*before, found->second) << text(c);
      seen.at_once += *before == found->second ? 1 : 0;
    }
    before = found->second;
    found->second = Rational(std::numeric_limits<double>::lowest());  // a second visit would not be in order
    ++visited;
  }
  ASSERT_EQ(visited, expected.size()) << text(c);
  EXPECT_FALSE(walk.next()) << text(c);
  seen.visited += static_cast<int>(visited);
}

/// Grids and lines of a kind: aimed at corners, or in walls, or off by ulps.
enum class Kind { plain, lattice, corner, corner_ulp, wall, wall_ulp, far, extreme };

double moved_by_ulp(double x, Entropy& entropy) {
  const int way = static_cast<int>(entropy.below(3));
  if (way == 0) return x;
  return std::nextafter(x, way == 1 ? std::numeric_limits<double>::max() : std::numeric_limits<double>::lowest());
}

template <std::size_t n>
Case<n> made(Kind kind, Entropy& entropy) {
  Case<n> c{};
  const auto unit = [&] { return static_cast<double>(entropy.bits(53)) * 0x1p-53; };
  c.is_segment = entropy.coin();
  const double scale = kind == Kind::extreme ? std::ldexp(1, static_cast<int>(entropy.within(1000))) : 1;
  for (std::size_t a = 0; a < n; ++a) {
    c.range.first[a] = -static_cast<std::int64_t>(entropy.below(3));
    c.range.last[a] = static_cast<std::int64_t>(entropy.below(n == 2 ? 6 : 4));
    const bool whole = kind == Kind::lattice;
    c.origin[a] = whole ? static_cast<double>(entropy.within(2)) : (unit() - 0.5) * scale;
    c.size[a] = whole ? static_cast<double>(1 + entropy.below(2)) : (unit() + 0.1) * scale;
    // A place in cells: a corner, or anywhere.
    const auto corner = [&] { return c.origin[a] + static_cast<double>(entropy.within(4)) * c.size[a]; };
    const double reach = kind == Kind::far ? 1e6 : 8;
    const auto place = [&] { return c.origin[a] + (unit() - 0.5) * reach * c.size[a]; };
    const bool aimed = kind == Kind::corner || kind == Kind::corner_ulp || kind == Kind::extreme;
    c.from[a] = whole ? static_cast<double>(entropy.within(6)) : place();
    if (aimed && entropy.below(4) == 0) c.from[a] = corner();
    double to = whole ? static_cast<double>(entropy.within(6)) : aimed ? corner() : place();
    if (kind == Kind::far) to = c.origin[a] + (unit() - 0.5) * 8 * c.size[a];
    if (kind == Kind::wall || kind == Kind::wall_ulp) {
      if (entropy.coin()) c.from[a] = to = corner();
    }
    if (kind == Kind::corner_ulp || kind == Kind::wall_ulp) {
      c.from[a] = moved_by_ulp(c.from[a], entropy), to = moved_by_ulp(to, entropy);
    }
    if (entropy.below(12) == 0) to = c.from[a];
    c.to[a] = c.is_segment ? to : to - c.from[a];
  }
  if (kind == Kind::extreme && entropy.below(4) == 0) {
    const std::size_t a = entropy.below(n);
    c.from[a] = entropy.coin() ? std::numeric_limits<double>::max() : -0x1p-1074;
  }
  return c;
}

template <std::size_t n>
void expect_kind(Kind kind, int cases, Seen& seen) {
  for (int i = 0; i < (battery::sanitized ? cases / 8 : cases); ++i) {
    Entropy entropy(7420 + static_cast<std::uint64_t>(kind), static_cast<std::uint64_t>(i));
    const Case<n> c = made<n>(kind, entropy);
    for (const WalkedCells cells : {WalkedCells::half_open, WalkedCells::closed}) {
      expect_exact(c, cells, seen);
      if (::testing::Test::HasFatalFailure()) return;
    }
  }
}

class GridWalkKinds : public ::testing::TestWithParam<Kind> {};

TEST_P(GridWalkKinds, VisitWhatRationalNumbersSay) {
  Seen plane, space;
  expect_kind<2>(GetParam(), 400, plane);
  expect_kind<3>(GetParam(), 150, space);
  if (!battery::reaches_rare) return;
  for (const Seen& seen : {plane, space}) {
    EXPECT_GT(seen.visited, seen.cases / 2);
    EXPECT_LT(seen.empty, seen.cases * 9 / 10);
    if (GetParam() != Kind::lattice && GetParam() != Kind::wall) continue;
    EXPECT_GT(seen.at_once, seen.cases / 10) << "cells to which a ray comes at once";
    if (GetParam() == Kind::wall) continue;
    EXPECT_GT(seen.only_touched, seen.cases / 4) << "cells of which only a point is visited";
  }
}

INSTANTIATE_TEST_SUITE_P(All, GridWalkKinds,
                         ::testing::Values(Kind::plain, Kind::lattice, Kind::corner, Kind::corner_ulp, Kind::wall,
                                           Kind::wall_ulp, Kind::far, Kind::extreme));

/// Of cells of one size and a ray from their origin, the size does not matter: the order of walls is that of whole
/// numbers, many windows long.
TEST(GridWalk, GoesOnExactlyForManyCells) {
  const int steps = battery::sanitized ? 20'000 : 200'000;
  for (const double size : {1.0, 0.1, 0x1.23456789abcdep-37, 1e200}) {
    for (const auto& [p, q] : {std::pair{3, 2}, {1, 1}, {1000, 1}, {123457, 98765}}) {
      GridWalk2 walk({{0, 0}, {size, size}}, Ray2{{0, 0}, {static_cast<double>(p), static_cast<double>(q)}},
                     {.cells = WalkedCells::half_open});
      std::int64_t i = 0, k = 0;
      for (int step = 0; step < steps; ++step) {
        ASSERT_TRUE(walk.next());
        ASSERT_EQ(walk.cell(), (Cell2{i, k})) << size << " " << p << " " << q << " step " << step;
        const std::int64_t x = (i + 1) * q, y = (k + 1) * p;
        i += x <= y ? 1 : 0, k += y <= x ? 1 : 0;
      }
    }
  }
}

/// Far from the origin: each cell by itself, and each begins where the one before it ends.
TEST(GridWalk, IsExactWhereCellsHaveLargeNumbers) {
  for (const double far : {1e9, 1e15, 2e18}) {
    for (int i = 0; i < 40; ++i) {
      Entropy entropy(7421, static_cast<std::uint64_t>(i));
      const auto way = [&] { return static_cast<double>(entropy.within(1000)) + 0.3; };
      const Case<3> c{{0.1, 0.2, 0.3}, {1, 0.7, 1.3}, {far, -far, far / 3}, {way(), way(), way()}, false, {}};
      GridWalk3 walk = walk_of(c, WalkedCells::half_open);
      std::optional<Rational> end;
      for (int step = 0; step < 30 && walk.next(); ++step) {
        const Stay stay = stay_in(c, walk.cell(), WalkedCells::half_open);
        ASSERT_TRUE(stay.is_somewhere()) << text(c);
        if (end) {
          ASSERT_EQ(*end, *stay.from) << text(c);
        }
        end = stay.to;
      }
      ASSERT_TRUE(end);
    }
  }
}

TEST(GridWalk, EndsWhereCellsHaveNoNumbers) {
  GridWalk2 walk({{0, 0}, {1, 1}}, Ray2{{0x1p62 - 1024, 0.5}, {1, 0}}, {.cells = WalkedCells::half_open});
  int cells = 0;
  while (walk.next()) ++cells;
  EXPECT_EQ(cells, 1024);
  EXPECT_EQ(walk.cell(), (Cell2{most_cell, 0}));
  GridWalk2 beyond({{0, 0}, {1, 1}}, Ray2{{1e300, 0.5}, {1, 0}});
  EXPECT_FALSE(beyond.next());
}

TEST(GridWalk, OfAPoint) {
  const CellGrid2 grid{{0, 0}, {1, 1}};
  GridWalk2 corner(grid, Segment2{{2, 3}, {2, 3}}, {.cells = WalkedCells::closed});
  std::vector<Cell2> cells;
  while (corner.next()) cells.push_back(corner.cell());
  EXPECT_EQ(cells, (std::vector<Cell2>{{1, 2}, {2, 2}, {1, 3}, {2, 3}}));
  GridWalk2 one(grid, Ray2{{2, 3}, {0, -0.0}}, {.cells = WalkedCells::half_open});
  ASSERT_TRUE(one.next());
  EXPECT_EQ(one.cell(), (Cell2{2, 3}));
  EXPECT_FALSE(one.next());
}

TEST(GridWalk, NamesWhatIsWrong) {
  const Ray2 ray{{0, 0}, {1, 1}};
  EXPECT_THAT(text_of<InvalidShape>([&] {
                GridWalk2({{0, 0}, {1, 0}}, ray);
              }),
              HasSubstr("grid.size.y is not above zero"));
  EXPECT_THAT(text_of<NonFinite>([&] { GridWalk2({{0, NAN}, {1, 1}}, ray); }), HasSubstr("grid.origin.y is nan"));
  EXPECT_THAT(text_of<NonFinite>([&] {
                GridWalk2({{0, 0}, {1, 1}}, Ray2{{0, 0}, {INFINITY, 1}});
              }),
              HasSubstr("ray.direction.x is inf"));
  GridWalk2 none({{0, 0}, {1, 1}}, ray, {.range = {{1, 0}, {0, 5}}});
  EXPECT_FALSE(none.next());
}

TEST(CellOf, IsTheFloorOfTheExactQuotient) {
  for (int i = 0; i < 3000; ++i) {
    Entropy entropy(7422, static_cast<std::uint64_t>(i));
    const double size = std::ldexp(1 + static_cast<double>(entropy.bits(20)), static_cast<int>(entropy.within(30)));
    const double origin = static_cast<double>(entropy.within(1000)) * 0.1;
    const double x = moved_by_ulp(origin + static_cast<double>(entropy.within(1 << 20)) * size, entropy);
    const Rational q = ((Rational(x) - Rational(origin)) / Rational(size)).floor();
    ASSERT_EQ(cell_of(CellGrid2{{origin, 0}, {size, 1}}, {x, 0})[0], *q.to_int64())
        << std::hexfloat << x << " " << size;
  }
  EXPECT_EQ(cell_of(CellGrid3{{0, 0, 0}, {1, 1, 5e-324}}, {-0.0, -5e-324, 1}), (Cell3{0, -1, most_cell}));
  EXPECT_THAT(text_of<InvalidShape>([] { cell_of(CellGrid2{{0, 0}, {-1, 1}}, {0, 0}); }), HasSubstr("grid.size.x"));
}

}  // namespace
}  // namespace plumb
