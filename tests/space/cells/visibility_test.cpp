// Are the chains that are seen those of linear programs in rational numbers, and is none of them missed by
// potentially_visible?
#include "plumb/space/cells/visibility.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/containment/polygon_location.hpp"
#include "plumb/query/lp/simplex.hpp"
#include "space/cells/rooms.hpp"

namespace plumb {
namespace {

using Chain = std::vector<std::uint32_t>;

std::array<Rational, 3> exact(const Point3& p) { return {Rational(p.x), Rational(p.y), Rational(p.z)}; }

/// Non-negative unknowns, and rows of them that are equal to or at least a number.
class Program {
 public:
  std::size_t unknowns = 0;
  struct Row {
    std::vector<std::pair<std::size_t, Rational>> terms;
    Rational limit;
    bool equal;
  };
  std::vector<Row> rows;

  [[nodiscard]] bool is_feasible() const {
    LinearSystem system;
    const auto add = [&](const Row& row, int sign) {  // sign row >= sign limit
      std::vector<Rational> dense(unknowns, Rational(0));
      for (const auto& [i, x] : row.terms) dense[i] = dense[i] - x * Rational(sign);
      system.add(std::move(dense), row.limit * Rational(-sign));
    };
    for (const Row& row : rows) {
      add(row, 1);
      if (row.equal) add(row, -1);
    }
    for (std::size_t i = 0; i < unknowns; ++i) add({{{i, Rational(1)}}, Rational(0), false}, 1);
    return maximize(std::vector<Rational>(unknowns, Rational(0)), system).kind != LinearKind::infeasible;
  }
};

/// Positive before the portal, on the side of the cell.
Rational before(const std::array<Point3, 3>& plane, const std::array<Rational, 3>& p) {
  const auto a = exact(plane[0]), b = exact(plane[1]), c = exact(plane[2]);
  std::array<Rational, 3> u, v, w;
  for (std::size_t k = 0; k < 3; ++k) u[k] = b[k] - a[k], v[k] = c[k] - a[k], w[k] = p[k] - a[k];
  return -(w[0] * (u[1] * v[2] - u[2] * v[1]) + w[1] * (u[2] * v[0] - u[0] * v[2]) +
           w[2] * (u[0] * v[1] - u[1] * v[0]));
}

/// Is there a place of the last portal whose segment from the eye goes through those before it (and the window's cone)?
bool seen_by_program(const PortalCells& rooms, std::uint32_t cell, const Chain& chain, const Point3& eye,
                     const Polygon3* window) {
  Program program;
  const auto& last = rooms.portals()[chain.back()].polygon.vertices;
  const auto e = exact(eye);
  Program::Row whole{{}, Rational(1), true};
  for (std::size_t i = 0; i < last.size(); ++i) whole.terms.emplace_back(program.unknowns++, Rational(1));
  program.rows.push_back(whole);
  const auto in_cone = [&](const Polygon3& polygon, bool behind) {
    const std::size_t first = program.unknowns;
    program.unknowns += polygon.vertices.size();
    Program::Row beyond{{}, Rational(1), false};
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) beyond.terms.emplace_back(first + i, Rational(1));
    if (behind) program.rows.push_back(beyond);
    for (std::size_t k = 0; k < 3; ++k) {
      Program::Row row{{}, Rational(0), true};
      for (std::size_t i = 0; i < last.size(); ++i) row.terms.emplace_back(i, exact(last[i])[k] - e[k]);
      for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
        row.terms.emplace_back(first + i, e[k] - exact(polygon.vertices[i])[k]);
      }
      program.rows.push_back(row);
    }
  };
  if (window != nullptr) in_cone(*window, false);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Polygon3& polygon = rooms.portals()[chain[i]].polygon;
    const auto plane = rooms.plane_before(chain[i], cell);
    const Rational side = before(plane, e);
    const bool on_first = i == 0 && side.sign() == Sign::zero && contains(polygon, eye);
    if (side.sign() != Sign::positive && !on_first) return false;
    cell = rooms.beyond(chain[i], cell);
    if (i + 1 == chain.size()) break;
    if (!on_first) {
      in_cone(polygon, true);
      continue;
    }
    Program::Row behind{{}, Rational(0), false};
    for (std::size_t k = 0; k < last.size(); ++k) behind.terms.emplace_back(k, -before(plane, exact(last[k])));
    program.rows.push_back(behind);
  }
  return program.is_feasible();
}

/// All chains of distinct cells; longer ones only of those that are seen.
void chains_by_program(const PortalCells& rooms, std::uint32_t first, const Point3& eye, const Polygon3* window,
                       std::uint32_t cell, std::set<std::uint32_t>& on_way, Chain& chain, std::vector<Chain>& seen) {
  for (const std::uint32_t portal : rooms.portals_of(cell)) {
    const std::uint32_t there = rooms.beyond(portal, cell);
    if (on_way.contains(there)) continue;
    chain.push_back(portal);
    if (seen_by_program(rooms, first, chain, eye, window)) {
      seen.push_back(chain);
      on_way.insert(there);
      chains_by_program(rooms, first, eye, window, there, on_way, chain, seen);
      on_way.erase(there);
    }
    chain.pop_back();
  }
}

std::vector<Chain> chains_of(const Sight& sight) {
  std::vector<Chain> chains;
  for (const SeenChain& c : sight.chains) chains.push_back(c.portals);
  return chains;
}

TEST(SeenFrom, IsWhatLinearProgramsSay) {
  std::size_t told = 0, longest = 0, points = 0;
  for (std::uint64_t i = 0; i < (battery::sanitized ? 2u : 8u); ++i) {
    Entropy e(831, i);
    const rooms::Made made = rooms::lattice(e, 3, 2, 2);
    const PortalCells all = made.rooms();
    for (int k = 0; k < 3; ++k) {
      const Point3 eye = rooms::place(made, e);
      const Point3 w = made.shear(4, 1, 1), u = made.shear(4, 2, 1), v = made.shear(4, 1, 2);
      const Polygon3 window{{w, u, v}};
      const Polygon3* through = e.below(3) == 0 ? &window : nullptr;
      const std::uint32_t cell = all.cells_holding(eye).back();
      const Sight sight = through != nullptr ? seen_from(all, cell, eye, window) : seen_from(all, cell, eye);
      std::vector<Chain> expected;
      std::set<std::uint32_t> on_way{cell};
      Chain chain;
      chains_by_program(all, cell, eye, through, cell, on_way, chain, expected);
      EXPECT_EQ(chains_of(sight), expected) << "Entropy e(831, " << i << "), eye " << k;
      std::set<std::uint32_t> cells{cell};
      for (const SeenChain& c : sight.chains) {
        cells.insert(c.cell);
        EXPECT_FALSE(c.window.empty());
        points += c.window.size() == 1 ? 1 : 0;
        longest = std::max(longest, c.portals.size());
      }
      EXPECT_EQ(sight.cells, std::vector<std::uint32_t>(cells.begin(), cells.end()));
      told += expected.size();
    }
  }
  EXPECT_GT(told, battery::sanitized ? 5u : 60u);
  EXPECT_GE(longest, battery::sanitized ? 1u : 3u);
  EXPECT_TRUE(points > 0 || !battery::reaches_rare);
}

TEST(PotentiallyVisible, MissesNothingThatIsSeen) {
  std::size_t seen = 0, hidden = 0;
  for (std::uint64_t i = 0; i < 10; ++i) {
    Entropy e(841, i);
    const rooms::Made made = rooms::lattice(e, 3, 2, 1 + static_cast<int>(e.below(2)));
    const PortalCells all = made.rooms();
    for (std::uint32_t cell = 0; cell < made.cells.size(); cell += 3) {
      const Sight sight = potentially_visible(all, cell);
      const std::vector<Chain> list = chains_of(sight);
      const std::set<Chain> chains(list.begin(), list.end());
      EXPECT_EQ(chains.size(), list.size());
      EXPECT_THAT(sight.cells, ::testing::Contains(cell));
      hidden += made.cells.size() - sight.cells.size();
      for (int k = 0; k < 12; ++k) {
        const Point3 eye = rooms::place(made, e);
        if (!contains(made.cells[cell], eye)) continue;
        for (const SeenChain& c : seen_from(all, cell, eye).chains) {
          ++seen;
          EXPECT_TRUE(chains.contains(c.portals)) << "Entropy e(841, " << i << "), cell " << cell << ", eye " << k;
        }
      }
    }
  }
  EXPECT_GT(seen, 40u);
  EXPECT_GT(hidden, 5u);
}

// Of up to three portals each corner of what is seen has a line through the first two.
TEST(PotentiallyVisible, OfThreePortalsTellsNoOthers) {
  std::size_t asked = 0;
  for (std::uint64_t i = 0; i < (battery::sanitized ? 1u : 6u); ++i) {
    Entropy e(851, i);
    const rooms::Made made = rooms::lattice(e, 2, 2, 2);
    const PortalCells all = made.rooms();
    for (const SeenChain& c : potentially_visible(all, 0).chains) {
      if (c.portals.size() != 3) continue;
      const auto& a = all.portals()[c.portals[0]].polygon.vertices;
      const auto& b = all.portals()[c.portals[1]].polygon.vertices;
      for (const ExactPoint3& corner : c.window) {
        const RationalPoint3 z = rational_point(corner);
        const std::array<Rational, 3> at{z.x, z.y, z.z};
        Program program;  // a place of b, less z, is a multiple of a place of a, less z
        program.unknowns = a.size() + b.size();
        Program::Row whole{{}, Rational(1), true};
        for (std::size_t k = 0; k < b.size(); ++k) whole.terms.emplace_back(a.size() + k, Rational(1));
        program.rows.push_back(whole);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          Program::Row row{{}, Rational(0), true};
          for (std::size_t k = 0; k < a.size(); ++k) row.terms.emplace_back(k, exact(a[k])[axis] - at[axis]);
          for (std::size_t k = 0; k < b.size(); ++k) {
            row.terms.emplace_back(a.size() + k, at[axis] - exact(b[k])[axis]);
          }
          program.rows.push_back(row);
        }
        EXPECT_TRUE(program.is_feasible()) << "Entropy e(851, " << i << ")";
        ++asked;
      }
    }
  }
  EXPECT_GT(asked, 10u);
}

/// Boxes in a row along x, with a rectangle of y and z in each wall.
PortalCells corridor(const std::vector<std::array<double, 4>>& doors) {
  const rooms::Shear straight;
  std::vector<ConvexPolyhedron3> cells;
  std::vector<Portal> portals;
  for (std::uint32_t i = 0; i <= doors.size(); ++i) {
    cells.push_back(rooms::box(straight, {1.0 * i, 0, 0}, {i + 1.0, 1, 1}));
    if (i == doors.size()) break;
    const auto& [y0, z0, y1, z1] = doors[i];
    const double x = i + 1.0;
    portals.push_back({{i, i + 1}, {{{x, y0, z0}, {x, y1, z0}, {x, y1, z1}, {x, y0, z1}}}});
  }
  return {cells, portals};
}

TEST(PotentiallyVisible, AlongACorridorWithDoorsAside) {
  using ::testing::ElementsAre;
  // From the first door through the second one sees to y = 1 of the third wall, and no farther.
  EXPECT_THAT(potentially_visible(corridor({{0, 0, 0.25, 1}, {0.5, 0, 0.625, 1}, {0.75, 0, 1, 1}}), 0).cells,
              ElementsAre(0, 1, 2, 3));
  const double above = std::nextafter(0.5, 1);
  EXPECT_THAT(potentially_visible(corridor({{0, 0, 0.25, 1}, {0, 0, 0.25, 1}, {0.5, 0, 1, 1}}), 0).cells,
              ElementsAre(0, 1, 2, 3));  // the line of y = 0, 0.25 and 0.5
  EXPECT_THAT(potentially_visible(corridor({{0, 0, 0.25, 1}, {0, 0, 0.25, 1}, {above, 0, 1, 1}}), 0).cells,
              ElementsAre(0, 1, 2));
  // A long one, without recursion.
  const std::vector<std::array<double, 4>> open(battery::sanitized ? 5 : 10, {0.25, 0.25, 0.75, 0.75});
  EXPECT_EQ(potentially_visible(corridor(open), 0).cells.size(), open.size() + 1);
  EXPECT_EQ(seen_from(corridor(open), 0, {0, 0.5, 0.5}).cells.size(), open.size() + 1);
}

// Four rooms around a pillar: a cycle; what is edge-on shows nothing; coplanar portals of one wall are not a way.
TEST(SeenFrom, CyclesAndPortalsInOnePlane) {
  const rooms::Shear straight;
  std::vector<ConvexPolyhedron3> cells;
  for (const double y : {0.0, 1.0}) {
    for (const double x : {0.0, 1.0}) cells.push_back(rooms::box(straight, {x, y, 0}, {x + 1, y + 1, 1}));
  }
  const auto wall_x = [](double y) { return Polygon3{{{1, y, 0}, {1, y + 1, 0}, {1, y + 1, 1}, {1, y, 1}}}; };
  const auto wall_y = [](double x) { return Polygon3{{{x, 1, 0}, {x + 1, 1, 0}, {x + 1, 1, 1}, {x, 1, 1}}}; };
  const PortalCells rooms(cells, {{{0, 1}, wall_x(0)}, {{2, 3}, wall_x(1)}, {{0, 2}, wall_y(0)}, {{1, 3}, wall_y(1)}});
  const Sight sight = seen_from(rooms, 0, {0.25, 0.25, 0.5});
  EXPECT_EQ(chains_of(sight), (std::vector<Chain>{{0}, {0, 3}, {2}, {2, 1}}));
  // On the wall's plane, outside the portal: the eye is in cell 0 and in the plane x = 1 of a smaller door.
  const PortalCells doors({cells[0], cells[1]}, {{{0, 1}, {{{1, 0.5, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0.5, 1}}}}});
  EXPECT_TRUE(seen_from(doors, 0, {1, 0.25, 0.5}).chains.empty());
  EXPECT_EQ(seen_from(doors, 0, {1, 0.5, 0.5}).chains.size(), 1u);
  EXPECT_EQ(seen_from(doors, 1, {1, 0.5, 0.5}).cells.size(), 2u);
  EXPECT_EQ(seen_from(doors, 0, {std::nextafter(1.0, 0), 0.25, 0.5}).chains.size(), 1u);
  // Cells without portals see themselves.
  EXPECT_EQ(potentially_visible(PortalCells(cells, {}), 2).cells, std::vector<std::uint32_t>{2});
}

TEST(SeenFrom, RefusesByName) {
  const PortalCells rooms = corridor({{0, 0, 1, 1}});
  using ::testing::HasSubstr;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(text_of<InvalidShape>([&] { (void)seen_from(rooms, 2, {0, 0, 0}); }), HasSubstr("no cell 2 among 2"));
  EXPECT_THAT(text_of<InvalidShape>([&] {
                (void)seen_from(rooms, 1, {0, 0, 0});
              }),
              HasSubstr("the eye is outside cell 1"));
  EXPECT_THAT(text_of<NonFinite>([&] {
                (void)seen_from(rooms, 1, {0, nan, 0});
              }),
              HasSubstr("seen_from: eye.y is nan"));
  EXPECT_THAT(text_of<InvalidShape>([&] {
                (void)seen_from(rooms, 0, {0, 0, 0}, {{{1, 0, 0}, {0, 1, 0}, {1, 1, 0}}});
              }),
              HasSubstr("the eye is in the window's plane"));
  EXPECT_THAT(text_of<InvalidShape>([&] {
                (void)seen_from(rooms, 0, {0, 0, 0}, {{{1, 0, 0}, {0, 1, 0}}});
              }),
              HasSubstr("the window is no convex polygon"));
}

}  // namespace
}  // namespace plumb
