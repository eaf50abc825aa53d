// Is each point told all cells and portals that it is in, and is what is no portal refused with its witness?
#include "plumb/space/cells/portal_cells.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "figure/basic/thrown.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/containment/polygon_location.hpp"
#include "plumb/predicates.hpp"
#include "space/cells/rooms.hpp"

namespace plumb {
namespace {

using Numbers = std::vector<std::uint32_t>;

TEST(PortalCells, TellAllThatHoldAPoint) {
  std::size_t in_two = 0, at_portals = 0, outside = 0;
  for (std::uint64_t i = 0; i < 20; ++i) {
    Entropy e(811, i);
    const rooms::Made made = rooms::lattice(e, 3, 2, 2);
    const PortalCells all = made.rooms();
    for (int k = 0; k < 40; ++k) {
      Point3 p = rooms::place(made, e);
      if (e.below(8) == 0) p.z = std::nextafter(p.z, e.coin() ? -9 : 9);
      Numbers cells, portals;
      for (std::uint32_t c = 0; c < made.cells.size(); ++c) {
        if (contains(made.cells[c], p)) cells.push_back(c);
      }
      for (std::uint32_t q = 0; q < made.portals.size(); ++q) {
        if (contains(made.portals[q].polygon, p)) portals.push_back(q);
      }
      EXPECT_EQ(all.cells_holding(p), cells) << "Entropy e(811, " << i << ")";
      EXPECT_EQ(all.portals_at(p), portals) << "Entropy e(811, " << i << ")";
      for (const std::uint32_t q : portals) {  // on a portal both are told
        for (const std::uint32_t c : made.portals[q].cells) EXPECT_THAT(cells, ::testing::Contains(c));
      }
      in_two += cells.size() > 1 ? 1 : 0, at_portals += portals.size(), outside += cells.empty() ? 1 : 0;
    }
    for (std::uint32_t c = 0; c < made.cells.size(); ++c) {
      for (const std::uint32_t q : all.portals_of(c)) {
        const auto& [a, b] = made.portals[q].cells;
        EXPECT_TRUE(a == c || b == c);
        EXPECT_EQ(all.beyond(q, c), a == c ? b : a);
        const auto plane = all.plane_before(q, c);
        for (const Point3& v : made.cells[c].mesh.vertices) {
          EXPECT_NE(orient3d(plane[0], plane[1], plane[2], v), Sign::negative);
        }
      }
    }
  }
  EXPECT_GT(in_two, 50u);
  EXPECT_GT(at_portals, 30u);
  EXPECT_GT(outside, 0u);
}

TEST(PortalCells, RefuseWhatIsNoPortalByItsWitness) {
  const rooms::Shear straight;
  const std::vector<ConvexPolyhedron3> cells{rooms::box(straight, {0, 0, 0}, {1, 1, 1}),
                                             rooms::box(straight, {1, 0, 0}, {2, 1, 1}),
                                             rooms::box(straight, {2, 0, 0}, {3, 1, 1})};
  const auto said = [&](std::uint32_t a, std::uint32_t b, std::vector<Point3> polygon) {
    return text_of<InvalidShape>([&] { (void)PortalCells(cells, {{{a, b}, {std::move(polygon)}}}); });
  };
  using ::testing::HasSubstr;
  const std::vector<Point3> whole{{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}};
  EXPECT_NO_THROW((void)PortalCells(cells, {{{0, 1}, {whole}}}));
  EXPECT_NO_THROW((void)PortalCells(cells, {{{1, 0}, {{whole[2], whole[1], whole[0]}}}}));
  EXPECT_THAT(said(0, 3, whole), HasSubstr("portals[0] names cell 3 of 3"));
  EXPECT_THAT(said(1, 1, whole), HasSubstr("leads from cell 1 into the same"));
  EXPECT_THAT(said(0, 2, whole), HasSubstr("polygon.vertices[0] is not in the face of cells[2] that"));
  const double beside = std::nextafter(1.0, 2);
  EXPECT_THAT(said(0, 1, {{1, 0, 0}, {1, beside, 0}, {1, 1, 1}}),
              HasSubstr("polygon.vertices[1] is not in the face of cells[0] that its plane holds"));
  EXPECT_THAT(said(0, 1, {{1, 0, 0}, {1, 1, 0}, {beside, 1, 1}}),
              HasSubstr("polygon.vertices[2] is not in the face of cells[0] that the others are in"));
  EXPECT_THAT(said(0, 1, {{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {beside, 0, 1}}), HasSubstr("does not lie in a plane"));
  EXPECT_THAT(said(0, 1, {{1, 0, 0}, {1, 1, 0}}), HasSubstr("fewer than three"));
  EXPECT_THAT(said(0, 1, {{1, 0, 0}, {1, 1, 0}, {1, 0.5, 0}}), HasSubstr("on one line"));
  EXPECT_THAT(said(0, 1, {{1, 0, 0}, {1, 1, 0}, {1, 0.25, 0.25}, {1, 0, 1}}), HasSubstr("turns to both sides"));
  std::vector<ConvexPolyhedron3> twice{cells[0], cells[0]};
  EXPECT_THAT(text_of<InvalidShape>([&] {
                (void)PortalCells(twice, {{{0, 1}, {whole}}});
              }),
              HasSubstr("has cells 0 and 1 on one side"));
  EXPECT_THAT(text_of<NonFinite>([&] {
                (void)PortalCells(
                    cells, {{{0, 1}, {{{1, 0, 0}, {1, std::numeric_limits<double>::quiet_NaN(), 0}, {1, 1, 1}}}}});
              }),
              HasSubstr("portals[0].polygon.vertices[1].y is nan"));
}

TEST(PortalCells, NoneHoldNothing) {
  const PortalCells none({}, {});
  EXPECT_TRUE(none.cells_holding({0, 0, 0}).empty());
  EXPECT_TRUE(none.portals_at({0, 0, 0}).empty());
}

}  // namespace
}  // namespace plumb
