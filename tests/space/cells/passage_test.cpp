// Does a passage arrive exactly where a chain of cells and portals covers the segment, and by the fewest portals?
#include "plumb/space/cells/passage.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <optional>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/query/section/intersection.hpp"
#include "space/cells/rooms.hpp"

namespace plumb {
namespace {

/// Where on the segment an exact point of it is.
Rational parameter(const Segment3& s, const ExactPoint3& p) {
  const RationalPoint3 at = rational_point(p);
  const auto along = [](const Rational& x, double a, double b) {
    return (x - Rational(a)) / (Rational(b) - Rational(a));
  };
  if (s.a.x != s.b.x) return along(at.x, s.a.x, s.b.x);
  if (s.a.y != s.b.y) return along(at.y, s.a.y, s.b.y);
  if (s.a.z != s.b.z) return along(at.z, s.a.z, s.b.z);
  return Rational(0);
}

struct Part {
  Rational from, to;
};
std::optional<Part> part_of(const Segment3& s, const Intersection3& common) {
  if (common.empty()) return std::nullopt;
  if (s.a == s.b) return Part{Rational(0), Rational(1)};
  const Rational a = parameter(s, common.vertices.front()), b = parameter(s, common.vertices.back());
  return a < b ? Part{a, b} : Part{b, a};
}

/// By brute force: chains of more and more portals, each cell with the soonest place that it can be come to.
struct Expected {
  bool arrives = false;
  std::size_t portals = 0;  // the fewest
  Rational until{0};
};
Expected by_brute_force(const rooms::Made& made, std::uint32_t cell, const Segment3& s) {
  const std::size_t n = made.cells.size();
  std::vector<std::optional<Part>> in_cell(n), on_portal;
  for (std::size_t c = 0; c < n; ++c) in_cell[c] = part_of(s, intersection(s, made.cells[c]));
  for (const Portal& p : made.portals) {  // all are convex: their fans of triangles
    std::optional<Part> all;
    for (std::size_t k = 2; k < p.polygon.vertices.size(); ++k) {
      const auto& v = p.polygon.vertices;
      const auto part = part_of(s, intersection(s, Triangle3{v[0], v[k - 1], v[k]}));
      if (!part) continue;
      all = all ? Part{std::min(all->from, part->from), std::max(all->to, part->to)} : *part;
    }
    on_portal.push_back(all);
  }
  std::vector<std::optional<Rational>> since(n);
  since[cell] = Rational(0);
  Expected e;
  for (std::size_t portals = 0; portals <= n; ++portals) {
    for (std::size_t c = 0; c < n; ++c) {
      if (!since[c]) continue;
      e.until = std::max(e.until, in_cell[c]->to);
      if (in_cell[c]->to == Rational(1)) {
        e.arrives = true, e.portals = portals;
        return e;
      }
    }
    auto next = since;
    for (std::size_t i = 0; i < made.portals.size(); ++i) {
      for (const std::size_t side : {0u, 1u}) {
        const std::uint32_t from = made.portals[i].cells[side], to = made.portals[i].cells[1 - side];
        if (!since[from] || !on_portal[i]) continue;
        const Rational at = std::max(*since[from], on_portal[i]->from);
        if (at > on_portal[i]->to || at > in_cell[from]->to) continue;
        if (!next[to] || at < *next[to]) next[to] = at;
      }
    }
    since = next;
  }
  return e;
}

TEST(Passage, ArrivesWhereAChainCoversTheSegment) {
  std::size_t arrived = 0, blocked = 0, longest = 0;
  for (std::uint64_t i = 0; i < (battery::sanitized ? 4u : 20u); ++i) {
    Entropy e(821, i);
    const rooms::Made made = rooms::lattice(e, 3, 3, 2);
    const PortalCells all = made.rooms();
    for (int k = 0; k < 20; ++k) {
      const Segment3 s{rooms::place(made, e), rooms::place(made, e)};
      for (const std::uint32_t cell : all.cells_holding(s.a)) {
        const Passage p = passage(all, cell, s);
        const Expected expected = by_brute_force(made, cell, s);
        const std::string text = "Entropy e(821, " + std::to_string(i) + "), segment " + std::to_string(k);
        EXPECT_EQ(p.arrives, expected.arrives) << text;
        EXPECT_EQ(p.until, expected.until) << text;
        EXPECT_TRUE(!p.arrives || p.portals.size() == expected.portals) << text;
        // The portals lead from cell to cell.
        std::uint32_t at = cell;
        for (const std::uint32_t portal : p.portals) {
          const auto& cells = made.portals[portal].cells;
          ASSERT_TRUE(cells[0] == at || cells[1] == at) << text;
          at = all.beyond(portal, at);
        }
        EXPECT_EQ(at, p.cell) << text;
        ++(p.arrives ? arrived : blocked);
        longest = std::max(longest, p.portals.size());
      }
    }
  }
  EXPECT_GT(arrived, battery::sanitized ? 10u : 100u);
  EXPECT_GT(blocked, battery::sanitized ? 10u : 100u);
  EXPECT_GE(longest, 3u);
}

TEST(Passage, ThroughACornerByTwoPortals) {
  const rooms::Shear straight;
  std::vector<ConvexPolyhedron3> cells;
  for (const double y : {0.0, 1.0}) {
    for (const double x : {0.0, 1.0}) cells.push_back(rooms::box(straight, {x, y, 0}, {x + 1, y + 1, 1}));
  }
  const PortalCells rooms(cells, {{{0, 1}, {{{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}}},
                                  {{1, 3}, {{{1, 1, 0}, {2, 1, 0}, {2, 1, 1}, {1, 1, 1}}}}});
  const Passage p = passage(rooms, 0, {{0.5, 0.5, 0.5}, {1.5, 1.5, 0.5}});
  EXPECT_TRUE(p.arrives);
  EXPECT_EQ(p.portals, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(p.cell, 3u);
  // An ulp above, and it comes to the wall of cells 0 and 2 first.
  const Passage q = passage(rooms, 0, {{0.5, 0.5, 0.5}, {1.5, std::nextafter(1.5, 2), 0.5}});
  EXPECT_FALSE(q.arrives);
  EXPECT_EQ(q.cell, 0u);
  EXPECT_EQ(q.until, Rational(0.5) / (Rational(std::nextafter(1.5, 2)) - Rational(0.5)));
}

TEST(PortalObjects, AreInTheCellThatTheyCameTo) {
  const rooms::Shear straight;
  const PortalCells rooms({rooms::box(straight, {0, 0, 0}, {1, 1, 1}), rooms::box(straight, {1, 0, 0}, {2, 1, 1})},
                          {{{0, 1}, {{{1, 0.25, 0}, {1, 0.75, 0}, {1, 0.75, 1}, {1, 0.25, 1}}}}});
  PortalObjects things(rooms);
  const std::uint32_t a = things.insert({0.5, 0.5, 0.5}), b = things.insert({1.5, 0.5, 0.5});
  using ::testing::ElementsAre;
  EXPECT_THAT(things.objects_in(0), ElementsAre(a));
  EXPECT_EQ(things.move(a, {1, 0.5, 0.5}).portals.size(), 0u);  // on the portal it is where it came from
  EXPECT_EQ(things.cell_of(a), 0u);
  EXPECT_THAT(things.move(a, {1.25, 0.5, 0.5}).portals, ElementsAre(0u));
  EXPECT_THAT(things.objects_in(1), ElementsAre(b, a));
  EXPECT_TRUE(things.objects_in(0).empty());
  EXPECT_FALSE(things.move(a, {0.9375, 1, 0.5}).arrives);  // the wall beside the portal
  EXPECT_EQ(things.place_of(a), (Point3{1.25, 0.5, 0.5}));
  things.remove(b);
  EXPECT_THAT(things.objects_in(1), ElementsAre(a));
  EXPECT_THAT(text_of<Error>([&] { things.remove(b); }), ::testing::HasSubstr("handle 1 holds no object"));
  EXPECT_THAT(text_of<InvalidShape>([&] { (void)things.insert({3, 0, 0}); }), ::testing::HasSubstr("in no cell"));
  EXPECT_EQ(things.insert({0, 0, 0}), b);
  EXPECT_THAT(text_of<InvalidShape>([&] {
                (void)passage(rooms, 1, {{0.5, 0, 0}, {1, 0, 0}});
              }),
              ::testing::HasSubstr("begins outside cell 1"));
  EXPECT_THAT(text_of<InvalidShape>([&] {
                (void)passage(rooms, 2, {{0.5, 0, 0}, {1, 0, 0}});
              }),
              ::testing::HasSubstr("there is no cell 2 among 2"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(text_of<NonFinite>([&] {
                (void)things.move(a, {nan, 0, 0});
              }),
              ::testing::HasSubstr("segment.b.x is nan"));
}

}  // namespace
}  // namespace plumb
