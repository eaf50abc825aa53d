// Sections of meshes by planes: known ones, and every law against rational arithmetic and winding numbers in space.
#include "plumb/surface/section/section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "figure/basic/solids.hpp"
#include "surface/section/section_oracle.hpp"

namespace plumb {
namespace {

using oracle::Shown;
constexpr Shown from_above{0, 1, false};

Plane3 at_height(double z) { return {{0, 0, 1}, z}; }

TEST(Section, ABoxIsCutFromItsBottomUpToItsTop) {
  const TriangleMesh mesh = solids::box({0, 0, 0}, {1, 2, 3});
  const Section bottom = section(mesh, at_height(0)), top = section(mesh, at_height(3));
  EXPECT_TRUE(bottom.contours.empty());
  EXPECT_EQ(bottom.coplanar_triangles.size(), 2U);
  ASSERT_EQ(top.contours.size(), 1U);
  EXPECT_EQ(top.contours[0].corners.size(), 4U);
  EXPECT_EQ(top.contours[0].turn, Sign::positive);
  EXPECT_EQ(top.coplanar_triangles.size(), 2U);
  EXPECT_EQ(top.corners_on_vertices, 4U);
  ASSERT_EQ(section(mesh, at_height(0), OnPlane::below).contours.size(), 1U);
  EXPECT_TRUE(section(mesh, at_height(3), OnPlane::below).contours.empty());
  const Section middle = section(mesh, at_height(1.5));
  ASSERT_EQ(middle.contours.size(), 1U);
  EXPECT_EQ(middle.contours[0].corners.size(), 8U);  // four edges and four diagonals
  EXPECT_EQ(middle.cut_triangles, 8U);
  EXPECT_EQ(middle.corners_on_vertices, 0U);
  EXPECT_EQ(oracle::doubled_area(oracle::flat_contours(mesh, middle, from_above)[0]), Rational(4));
  EXPECT_TRUE(section(mesh, at_height(4)).contours.empty());
}

TEST(Section, SeenFromTheOtherSideItTurnsTheOtherWay) {
  const TriangleMesh mesh = solids::box({0, 0, 0}, {1, 1, 1});
  const Section down = section(mesh, Plane3{{0, 0, -1}, -0.5});
  ASSERT_EQ(down.contours.size(), 1U);
  EXPECT_EQ(down.contours[0].turn, Sign::positive);
  EXPECT_LT(oracle::doubled_area(oracle::flat_contours(mesh, down, from_above)[0]), Rational(0));
  // The normal's side of z = 1 turned over is below: the top counts as above the plane no longer.
  EXPECT_TRUE(section(mesh, Plane3{{0, 0, -1}, -1}).contours.empty());
  EXPECT_EQ(section(mesh, Plane3{{0, 0, -1}, 0}).contours.size(), 1U);
}

TEST(Section, ShellsLieInOneAnother) {
  TriangleMesh mesh;
  for (int k = 0; k < 5; ++k) {
    const double r = 10 - 2 * k;
    solids::append(mesh, solids::box({-r, -r, -r}, {r, r, r}), k % 2 == 1);
  }
  solids::append(mesh, solids::box({-9, 8.5, -1}, {-8.5, 9, 1}));  // in the outer wall
  const Section cut = section(mesh, Plane3{{1, 2, 3}, 0.25});
  ASSERT_EQ(cut.contours.size(), 5U);
  const Section level = section(mesh, at_height(0.5));
  ASSERT_EQ(level.contours.size(), 6U);
  std::vector<std::uint32_t> depths;
  for (const Contour& c : level.contours) {
    depths.push_back(c.depth);
    if (c.depth == 0) continue;
    ASSERT_TRUE(c.parent);
    EXPECT_EQ(level.contours[*c.parent].depth, c.depth - 1);
  }
  std::ranges::sort(depths);
  EXPECT_EQ(depths, (std::vector<std::uint32_t>{0, 1, 1, 2, 3, 4}));
  EXPECT_EQ(std::ranges::count(level.contours, Sign::negative, &Contour::turn), 2);
}

TEST(Section, TheSameSurfaceTwiceLiesInItself) {
  TriangleMesh mesh = solids::torus(3, 1, 12, 8);
  solids::append(mesh, TriangleMesh(mesh));
  using Depths = std::vector<std::uint32_t>;
  for (const auto& [plane, expected] :  // a ring, and two rounds apart
       {std::pair(at_height(0.1), Depths{0, 1, 2, 3}), std::pair(Plane3{{1, 2, 4}, 0.5}, Depths{0, 0, 1, 1})}) {
    const Section cut = section(mesh, plane);
    Depths depths;
    for (const Contour& c : cut.contours) depths.push_back(c.depth);
    std::ranges::sort(depths);
    EXPECT_EQ(depths, expected);
    oracle::expect_nested(mesh, cut);
  }
}

// The contour is a comb of ten teeth that hangs from a beam: of the pillars in its box, those in the beam and in
// teeth lie in it, those in the gaps do not.
TEST(Section, ManyContoursLieInAJaggedOne) {
  constexpr int teeth = 10;
  std::vector<Point2> comb{{2 * teeth - 1, 2 * teeth}, {0, 2 * teeth}};
  for (int k = 0; k < teeth; ++k)
    comb.insert(comb.end(), {{2.0 * k, 0}, {2.0 * k + 1, 0}, {2.0 * k + 1, teeth}, {2.0 * k + 2, teeth}});
  comb.resize(comb.size() - 2);
  TriangleMesh mesh = solids::walls(comb);
  solids::append(mesh, solids::pillars(2 * teeth - 1));
  for (const Plane3& plane : {at_height(0.5), Plane3{{0.001, 0.002, 1}, 0.05}}) {
    const Section cut = section(mesh, plane);
    ASSERT_EQ(cut.contours.size(), 1 + (2 * teeth - 1) * (2 * teeth - 1));
    const auto around = std::ranges::max_element(cut.contours, {}, [](const Contour& c) { return c.corners.size(); });
    for (const Contour& c : cut.contours) {
      if (&c == &*around) continue;
      const auto x = static_cast<int>(c.corners[0].nearest.x), y = static_cast<int>(c.corners[0].nearest.y);
      const bool is_in = y >= teeth || x % 2 == 0;
      ASSERT_EQ(c.depth, is_in ? 1U : 0U) << x << ' ' << y;
      ASSERT_EQ(c.parent,
                is_in ? std::optional(static_cast<std::uint32_t>(around - cut.contours.begin())) : std::nullopt);
    }
  }
}

TEST(Section, ATorusGivesARingOrTwoRounds) {
  const TriangleMesh mesh = solids::torus(3, 1, 40, 20);
  const Section ring = section(mesh, at_height(0.1));
  ASSERT_EQ(ring.contours.size(), 2U);
  const bool first_is_outer = ring.contours[0].depth == 0;
  const Contour &outer = ring.contours[first_is_outer ? 0 : 1], &hole = ring.contours[first_is_outer ? 1 : 0];
  EXPECT_EQ(outer.turn, Sign::positive);
  EXPECT_EQ(hole.turn, Sign::negative);
  EXPECT_EQ(hole.depth, 1U);
  const Section rounds = section(mesh, Plane3{{1, 0, 0}, 0.125});
  ASSERT_EQ(rounds.contours.size(), 2U);
  for (const Contour& c : rounds.contours) EXPECT_TRUE(c.turn == Sign::positive && c.depth == 0);
  oracle::expect_lawful(mesh, ring, from_above);
  oracle::expect_lawful(mesh, rounds, {1, 2, false});
}

TEST(Section, WhatIsOpenEndsInChains) {
  TriangleMesh mesh = solids::box({0, 0, 0}, {1, 1, 1});
  std::erase_if(mesh.triangles, [&](const TriangleMesh::Triangle& t) {
    return std::ranges::all_of(t, [&](std::uint32_t v) { return mesh.vertices[v].x == 1; });
  });
  const Section cut = section(mesh, at_height(0.5));
  ASSERT_EQ(cut.contours.size(), 1U);
  EXPECT_FALSE(cut.contours[0].closed);
  EXPECT_EQ(cut.contours[0].corners.size(), 7U);
  EXPECT_EQ(cut.contours[0].corners.front().nearest, (Point3{1, 1, 0.5}));
  EXPECT_EQ(cut.contours[0].corners.back().nearest, (Point3{1, 0, 0.5}));
  oracle::expect_lawful(mesh, cut, from_above);
}

TEST(Section, ATriangleThatIsWoundAgainstTheOthersBreaksTheContour) {
  TriangleMesh mesh = solids::box({0, 0, 0}, {1, 1, 1});
  const Section whole = section(mesh, at_height(0.5));
  ASSERT_EQ(whole.contours.size(), 1U);
  for (auto& t : mesh.triangles) {
    if (mesh.vertices[t[0]].x + mesh.vertices[t[1]].x + mesh.vertices[t[2]].x == 3) {
      std::swap(t[0], t[1]);
      break;
    }
  }
  const Section cut = section(mesh, at_height(0.5));
  ASSERT_EQ(cut.contours.size(), 2U);
  EXPECT_FALSE(cut.contours[0].closed || cut.contours[1].closed);
}

TEST(Section, SolidsThatShareAWallAreOne) {
  TriangleMesh mesh = solids::box({0, 0, 0}, {1, 1, 1});
  solids::append(mesh, solids::box({1, 0, 0}, {2, 1, 1}));
  const Section top = section(mesh, at_height(1));
  ASSERT_EQ(top.contours.size(), 1U);
  EXPECT_EQ(top.canceled_segments, 1U);
  EXPECT_EQ(top.contours[0].corners.size(), 6U);
  EXPECT_EQ(oracle::doubled_area(oracle::flat_contours(mesh, top, from_above)[0]), Rational(4));
}

TEST(Section, TheSamePlaneBySeveralNames) {
  const TriangleMesh mesh = solids::torus(3, 1, 17, 9);
  const Section cut = section(mesh, at_height(0.25));
  for (const AnyPlane3& plane :
       {AnyPlane3(Plane3{{0, 0, 4}, 1}), AnyPlane3(ThreePointPlane3{{0, 0, 0.25}, {5, 1, 0.25}, {1, 7, 0.25}})}) {
    const Section other = section(mesh, plane);
    ASSERT_EQ(other.contours.size(), cut.contours.size());
    for (std::size_t i = 0; i < cut.contours.size(); ++i) {
      EXPECT_EQ(other.contours[i].corners, cut.contours[i].corners);
      EXPECT_EQ(other.contours[i].turn, cut.contours[i].turn);
      EXPECT_EQ(other.contours[i].parent, cut.contours[i].parent);
    }
  }
}

TEST(Section, ManyPlanesGiveWhatEachGives) {
  std::mt19937_64 random(15);
  const TriangleMesh mesh = solids::heap(random, 12, 3);
  TriangleMesh shuffled = mesh;
  std::shuffle(shuffled.triangles.begin(), shuffled.triangles.end(), random);
  std::vector<AnyPlane3> planes;
  for (const double h : {2.0, -1.0, 0.5, 0.0, 2.0, 9.0, -3.0}) {
    planes.emplace_back(at_height(h));
    planes.emplace_back(Plane3{{0, -1, 0}, h});
    planes.emplace_back(Plane3{{1, 1, 2}, h});
    planes.emplace_back(Plane3{{-1, -1, -2}, h});
    planes.emplace_back(ThreePointPlane3{{0, 0, h}, {1, 0, h}, {0, 1, h}});
  }
  const std::vector<Section> all = sections(mesh, planes);
  ASSERT_EQ(all.size(), planes.size());
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (const Section& one : {section(mesh, planes[i]), section(shuffled, planes[i])}) {
      ASSERT_EQ(one.contours.size(), all[i].contours.size());
      for (std::size_t c = 0; c < one.contours.size(); ++c)
        EXPECT_EQ(one.contours[c].corners, all[i].contours[c].corners);
      EXPECT_EQ(one.coplanar_triangles.size(), all[i].coplanar_triangles.size());
      EXPECT_EQ(one.cut_triangles, all[i].cut_triangles);
    }
  }
}

TEST(Section, PowersOfTwoChangeNothing) {
  std::mt19937_64 random(4);
  for (int round = 0; round < 20; ++round) {
    const TriangleMesh mesh = solids::heap(random, 6, 4);
    for (const double scale : {0x1p1021, 0x1p-1074}) {  // the largest doubles, and subnormal numbers
      TriangleMesh scaled = mesh;
      for (Point3& p : scaled.vertices) p = {p.x * scale, p.y * scale, p.z * scale};
      for (const Vector3& normal : {Vector3{0, 0, 1}, Vector3{1, -1, 2}}) {
        const Section one = section(mesh, Plane3{normal, 1}), other = section(scaled, Plane3{normal, scale});
        ASSERT_EQ(one.contours.size(), other.contours.size());
        for (std::size_t c = 0; c < one.contours.size(); ++c) {
          const Contour &a = one.contours[c], &b = other.contours[c];
          EXPECT_TRUE(a.turn == b.turn && a.parent == b.parent && a.depth == b.depth && a.closed == b.closed);
          ASSERT_EQ(a.corners.size(), b.corners.size());
          for (std::size_t k = 0; k < a.corners.size(); ++k)
            EXPECT_TRUE(a.corners[k].below == b.corners[k].below && a.corners[k].above == b.corners[k].above);
        }
      }
    }
  }
}

TEST(Section, BadInputIsNamed) {
  TriangleMesh mesh = solids::box({0, 0, 0}, {1, 1, 1});
  EXPECT_THROW(section(mesh, Plane3{{0, 0, 0}, 0}), InvalidShape);
  EXPECT_THROW(section(mesh, ThreePointPlane3{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}), InvalidShape);
  EXPECT_THROW(section(mesh, at_height(NAN)), NonFinite);
  mesh.vertices[3].y = INFINITY;
  EXPECT_THROW(section(mesh, at_height(0.5)), NonFinite);
  mesh.vertices[3].y = 0;
  mesh.triangles[0][1] = 99;
  EXPECT_THROW(section(mesh, at_height(0.5)), InvalidShape);
}

}  // namespace
}  // namespace plumb
