// What the laboratory finds: exact methods fail nothing, the usual ones fail where textbooks say that they do, and the
// parts that count can tell.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "lab/found.hpp"
#include "lab/stability/hull_judge.hpp"
#include "lab/stability/png.hpp"
#include "lab/stability/segment_methods.hpp"
#include "lab/stability/space_hull_judge.hpp"
#include "lab/stability/sweep.hpp"
#include "plumb/degenerate/cloud.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/figure/hull/hull2.hpp"
#include "plumb/figure/hull/hull3.hpp"

namespace plumb::lab::stability {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(Grid, ShowsFloatsOnTheWrongSideAndOffTheLine) {
  const Found found = found_by(grid_experiment());
  EXPECT_EQ(found.pictures.size(), 10U);
  const auto& f = found.failures;
  EXPECT_GT(f.at("double: points put on the wrong side of the line"), 0U);
  EXPECT_GT(f.at("double: points off the line put on it"), 0U);
  EXPECT_GT(f.at("double: points on the plane put off it"), 0U);
  EXPECT_GT(f.at("float32: points on the plane put off it"), 0U);
  EXPECT_GT(f.at("absolute: points off the sphere put on it"), f.at("long-double: points off the sphere put on it"));
  EXPECT_GT(f.at("double: points off the circle put on it"), 0U);
  EXPECT_GT(f.at("double: points answered otherwise when the others are named in another order"), 0U);
  EXPECT_EQ(f.at("absolute: points put on the wrong side of the line"), 0U);  // an epsilon trades these for zeros
}

TEST(Hulls, LoseCornersBendInwardsAndDoNotEndInFloatingPoint) {
  const Found found = found_by(hull_experiment());
  EXPECT_GE(found.pictures.size(), 8U);
  for (const char* method : {"float32", "double", "absolute", "relative"}) {
    EXPECT_GT(found.failures.at(std::string(method) + ": hulls that lost an extreme point"), 0U) << method;
    EXPECT_GT(found.failures.at(std::string(method) + ": hulls that leave points outside"), 0U) << method;
  }
  EXPECT_GT(found.failures.at("double: hulls that are not convex"), 0U);
  EXPECT_GT(found.failures.at("double: hulls with a corner that is none"), 0U);
  EXPECT_GT(found.failures.at("float32: runs that did not end"), 0U);
}

TEST(SpaceHulls, LoseCornersAndTearInFloatingPoint) {
  const Found found = found_by(space_hull_experiment());
  EXPECT_GE(found.pictures.size(), 6U);
  for (const char* method : {"float32", "double", "absolute", "relative"}) {
    const std::string m = method;
    EXPECT_GT(found.failures.at(m + ": hulls that lost an extreme point"), 0U) << m;
    EXPECT_GT(found.failures.at(m + ": hulls with a face that has points on its outer side"), 0U) << m;
  }
  EXPECT_GT(found.failures.at("double: hulls with an edge that has not two faces"), 0U);
  EXPECT_GT(found.failures.at("double: runs that did not end"), 0U);
}

TEST(Segments, AreMissedInFloatingPointAndCrossOnNeither) {
  const Found found = found_by(segment_experiment());
  const auto& f = found.failures;
  EXPECT_GT(f.at("double: pairs that meet and are said not to"), 0U);
  EXPECT_GT(f.at("double: pairs answered otherwise when swapped or reversed"), 0U);
  EXPECT_GT(f.at("double: crossing points that lie on neither segment"), 0U);
  EXPECT_GT(f.at("double: crossing points that are not the nearest doubles"), 0U);
  EXPECT_GT(f.at("double: segments through the shared end that are said to miss both"), 0U);
  EXPECT_GT(f.at("double: segments through the shared end that are said to meet one and miss the other"), 0U);
}

TEST(Worlds, LoseWhatTouchesAndInventTouches) {
  bool saw_bodies = false;
  const WorldRival none{"blind", [&](std::span<const WorldBody> bodies) {
                          saw_bodies = saw_bodies || bodies.size() >= 60;
                          return BodyPairs{};
                        }};
  const WorldRival all{"all", [](std::span<const WorldBody> bodies) {
                         BodyPairs pairs;
                         for (std::uint32_t j = 0; j < bodies.size(); ++j)
                           for (std::uint32_t i = 0; i < j; ++i) pairs.insert({i, j});
                         return pairs;
                       }};
  const Found found = found_by(world_experiment({none, all}));
  const auto& f = found.failures;
  EXPECT_TRUE(saw_bodies);
  EXPECT_GT(f.at("double: pairs that meet and are not told"), 0U);
  EXPECT_GT(f.at("double: pairs that are told and do not meet"), 0U);
  for (const auto& [scene, methods] : found.scenes) {
    EXPECT_GT(methods.at("blind")[0].of, 5U) << scene;
    EXPECT_EQ(methods.at("blind")[0].failures, methods.at("blind")[0].of) << scene;
    EXPECT_EQ(methods.at("all")[0].failures, 0U) << scene;
    EXPECT_EQ(methods.at("all")[1].failures, methods.at("all")[1].of) << scene;
  }
}

TEST(Sweeps, LoseAndInventPairsInFloatingPoint) {
  const Found found = found_by(sweep_experiment());
  EXPECT_GT(found.failures.at("double: pairs that meet and were lost"), 0U);
  EXPECT_GT(found.failures.at("float32: pairs that do not meet and were reported"), 0U);
}

TEST(BoxesAtTouch, AreLostAndInventedInFloatingPoint) {
  const Found found = found_by(touch_experiment());
  const auto& f = found.failures;
  EXPECT_GT(f.at("float32: pairs named that do not overlap"), 0U);
  EXPECT_EQ(found.in("touching", "float32", 2), 0U);  // equal doubles round to equal floats
  EXPECT_GT(f.at("double: pairs that overlap and were lost"), 0U);
  EXPECT_GT(found.in("touching", "double", 3), 0U);  // centers and half lengths round
  EXPECT_EQ(found.in("uniform", "double", 0), 0U);
}

TEST(NearEquidistant, NeighborsAreMistakenInFloatingPoint) {
  const Found found = found_by(neighbor_experiment());
  EXPECT_GT(found.in("near_ties", "double", 0), 0U);
  EXPECT_GT(found.in("near_ties", "float32", 0), found.in("near_ties", "double", 0));
  EXPECT_GT(found.in("far_away", "float32", 2), 0U);
  EXPECT_EQ(found.in("uniform", "double", 0), 0U);
}

TEST(WalksAlongCorners, LeaveCellsOutInFloatingPoint) {
  const Found found = found_by(walk_experiment());
  for (const char* method : {"float32", "double", "recomputed"}) {
    EXPECT_GT(found.in("corners", method, 0), 0U) << method;
    EXPECT_GT(found.in("touched", method, 3), 0U) << method;
  }
  EXPECT_EQ(found.in("uniform", "double", 0), 0U);
}

TEST(Triangulations, LoseVerticesAndAreaInFloatingPoint) {
  const Found found = found_by(triangulation_experiment());
  for (const char* method : {"float32", "double", "absolute", "relative", "long-double"}) {
    EXPECT_GT(found.in("bridged-hole", method, 0), 0U)
        << method << ": whatever the numbers, a vertex on an edge is lost";
    EXPECT_EQ(found.in("stars", method, 0) + found.in("stars", method, 1), 0U) << method;
    EXPECT_EQ(found.in("lattice", method, 0) + found.in("lattice", method, 1), 0U) << method;
  }
  EXPECT_GT(found.in("strip", "double", 1), 0U);
  EXPECT_GT(found.in("tenths", "double", 1), 0U);
  EXPECT_GT(found.in("small", "absolute", 0) + found.in("small", "absolute", 4), 0U)
      << "an epsilon takes all for nothing";
}

TEST(Welding, LosesVerticesAndHangsOnTheOrder) {
  const Found found = found_by(welding_experiment());
  EXPECT_GT(found.in("pairs", "grid", 0), 0U) << "the border of cells runs between";
  EXPECT_GT(found.in("copies", "hashing", 0), 0U);
  EXPECT_GT(found.in("zeros", "hashing", 3) + found.in("zeros", "hashing", 0), 0U);
  EXPECT_GT(found.in("chains", "first-come", 3), 0U);
  EXPECT_GT(found.in("far", "sorted", 0), 0U);
  EXPECT_GT(found.in("pairs", "sorted", 1), 0U) << "floats lose vertices that are ulps too far";
}

TEST(Booleans, ComeOpenAndOfAnotherVolumeFromTreesOfPlanesInFloats) {
  const Found found = found_by(boolean_experiment());
  for (const char* method : {"float32", "double", "absolute", "relative", "long-double"}) {
    EXPECT_GT(found.in("scattered", method, 0), 0U) << method << ": an edge is cut on one side of it alone";
    EXPECT_EQ(found.in("chains", method, 2), 0U) << method << ": integers are right in each kind of numbers";
  }
  EXPECT_GT(found.in("scattered", "double", 2), 0U) << "a face is cut by its own plane";
  EXPECT_EQ(found.in("on-a-lattice", "absolute", 2), 0U);
  EXPECT_GT(found.in("small", "absolute", 2), 0U) << "an epsilon takes all for one plane";
  EXPECT_GT(found.in("off-by-ulps", "double", 2), 0U);
}

TEST(Experiments, AreExactForOtherInputsAsWellAndRepeatable) {
  for (const Experiment& e : {hull_experiment(), space_hull_experiment(), segment_experiment(), sweep_experiment(),
                              triangulation_experiment(), welding_experiment(), boolean_experiment()}) {
    const auto other = found_by(e, 7).failures;
    EXPECT_EQ(other, found_by(e, 7).failures);
    EXPECT_NE(other, found_by(e).failures);
  }
}

/// The points of a hull, smallest first by x, then y, so that hulls compare.
std::vector<Point2> corners_of(const std::vector<std::uint32_t>& corners, const std::vector<Point2>& points) {
  std::vector<Point2> hull;
  for (const std::uint32_t c : corners) hull.push_back(points[c]);
  const auto before = [](const Point2& a, const Point2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
  std::rotate(hull.begin(), std::ranges::min_element(hull, before), hull.end());
  return hull;
}

TEST(HullWays, FindWhatTheLibraryFindsWhenSignsAreExact) {
  const HullMethod<2>& exact = hull_methods<2>().back();
  ASSERT_TRUE(exact.exact);
  for (std::size_t i = 0; i < families.size() + clouds.size(); ++i) {
    for (std::size_t count : {1U, 2U, 3U, 20U}) {
      Entropy entropy(1, i);
      const std::vector<Point2> points = i < families.size()
                                             ? points2(families[i].family, Degeneracy::collinear, count, entropy)
                                             : cloud2(clouds[i - families.size()].cloud, count, entropy);
      const std::vector<Point2> truth = corners_of(convex_hull(points).vertices, points);
      EXPECT_EQ(corners_of(HullJudge(points).corners(), points), truth) << "start 1, index " << i;
      for (const HullWay& way : hull_ways()) {
        const Corners corners = way.run(*exact.signs(points));
        ASSERT_TRUE(corners) << way.name;
        EXPECT_EQ(corners_of(*corners, points), truth) << way.name << ", start 1, index " << i;
      }
    }
  }
}

TEST(SpaceHullWays, FindWhatTheLibraryFindsWhenSignsAreExact) {
  for (std::size_t i = 0; i < clouds.size() + families.size(); ++i) {
    for (const std::size_t count : {1U, 2U, 3U, 4U, 5U, 20U}) {
      Entropy entropy(1, i);
      const std::vector<Point3> points =
          i < clouds.size() ? cloud3(clouds[i].cloud, count, entropy)
                            : points3(families[i - clouds.size()].family, Degeneracy::coplanar, count, entropy);
      const Hull3 truth = convex_hull(points);
      const SpaceHullJudge judge(points);
      for (const SpaceHullWay& way : space_hull_ways()) {
        const std::string where = way.name + ", start 1, index " + std::to_string(i);
        const auto faces = way.run(*hull_methods<3>().back().signs(points));
        ASSERT_TRUE(faces) << where;
        EXPECT_EQ(faces->empty(), truth.dimension < 3) << where;
        EXPECT_TRUE(judge.flaws(*faces) == SpaceHullFlaws{}) << where;
        if (way.name != "gift wrapping") continue;
        EXPECT_EQ(faces->size(), truth.dimension < 3 ? 0 : truth.face_count()) << where;
      }
    }
  }
}

TEST(SpaceHullJudge, TellsEveryFlaw) {
  // A cube, the middle of its lower side, a corner once more, and a point inside.
  const std::vector<Point3> points{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2},
                                   {2, 2, 2}, {0, 2, 2}, {1, 1, 0}, {2, 2, 2}, {1, 1, 1}};
  const SpaceHullJudge judge(points);
  const Faces cube{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 9, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  const auto told = [&](Faces faces, std::size_t without = 9, const Faces& and_these = {}) {
    if (without < faces.size()) faces.erase(faces.begin() + static_cast<std::ptrdiff_t>(without));
    faces.insert(faces.end(), and_these.begin(), and_these.end());
    const SpaceHullFlaws f = judge.flaws(faces);
    return std::string(f.wrong_dimension ? "dimension " : "") + (f.lost.empty() ? "" : "lost ") +
           (f.seen.empty() ? "" : "seen ") + (f.flat.empty() ? "" : "flat ") + (f.torn.empty() ? "" : "torn ");
  };
  EXPECT_EQ(told(cube), "");
  EXPECT_EQ(told(cube, 0, {{0, 8, 1}, {1, 8, 2}, {2, 8, 3}, {3, 8, 0}}), "");  // side by side in one plane
  EXPECT_EQ(told(cube, 0), "torn ");
  EXPECT_EQ(told(cube, 9, {cube[0]}), "torn ");
  EXPECT_EQ(told(cube, 0, {{0, 1, 2, 3}}), "seen torn ");  // the other way round
  EXPECT_EQ(told(cube, 0, {{0, 8, 2, 1}, {0, 3, 2, 8}}), "flat ");
  EXPECT_EQ(told(cube, 0, {{0, 10, 1}, {1, 10, 2}, {2, 10, 3}, {3, 10, 0}}), "seen ");
  EXPECT_EQ(told({{0, 2, 1}, {0, 1, 5}, {1, 2, 5}, {0, 5, 2}}), "lost seen ");
  EXPECT_EQ(told({}), "dimension ");
  const SpaceHullJudge flat(std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  EXPECT_FALSE(flat.flaws({}).wrong_dimension);
  EXPECT_TRUE(flat.flaws({{0, 1, 2}}).wrong_dimension);
}

TEST(HullJudge, TellsEveryFlaw) {
  const std::vector<Point2> points{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}, {2, 0}, {0, 0}, {-0.0, 4}};
  const HullJudge judge(points);
  const auto told = [&](const std::vector<std::uint32_t>& corners) {
    const HullFlaws f = judge.flaws(corners);
    return std::string(f.not_convex ? "bent " : "") + (f.leaves_out ? "out " : "") + (f.lost ? "lost " : "") +
           (f.no_corner ? "none " : "");
  };
  EXPECT_EQ(told({0, 1, 2, 3}), "");
  EXPECT_EQ(told({6, 1, 2, 7}), "");  // equal points, whichever is named
  EXPECT_EQ(told({0, 1, 2}), "out lost ");
  EXPECT_EQ(told({0, 5, 1, 2, 3}), "none ");
  EXPECT_EQ(told({0, 1, 2, 3, 6}), "none ");
  EXPECT_EQ(told({0, 1, 2, 4, 3}), "bent out none ");
  EXPECT_EQ(told({0, 3, 2, 1}), "bent out ");  // clockwise
  EXPECT_EQ(told({0}), "out lost ");
  EXPECT_EQ(told({0, 2}), "out lost ");
  EXPECT_EQ(told({}), "lost ");
  EXPECT_EQ(judge.flaws({0, 1, 2}).worst_outside, 0.5);
}

TEST(Sweep, FindsTouchingCrossingAndOverlappingSegments) {
  const auto pairs = [](const std::vector<Segment2>& segments) {
    std::vector<trial::Segment<Rational>> exact;
    for (const Segment2& s : segments) exact.push_back(converted<Rational>(s));
    return Sweep<Rational>(std::move(exact), Rational()).run().value();
  };
  EXPECT_THAT(pairs({}), testing::IsEmpty());
  EXPECT_THAT(pairs({{{0, 0}, {4, 4}}, {{0, 4}, {4, 0}}, {{2, 2}, {9, 2}}, {{5, 5}, {6, 6}}}),
              testing::ElementsAre(std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)));
  EXPECT_THAT(
      pairs({{{0, 0}, {4, 0}}, {{2, 0}, {6, 0}}, {{3, -1}, {3, 1}}, {{3, 1}, {3, 1}}, {{5, 0}, {5, 0}}}),
      testing::ElementsAre(std::pair(0, 1), std::pair(0, 2), std::pair(1, 2), std::pair(1, 4), std::pair(2, 3)));
}

TEST(Png, IsWhatBrowsersRead) {
  const std::array<Color, 2> palette{{{0, 0, 0}, {255, 0, 128}}};
  const std::vector<std::uint8_t> pixels{0, 1, 1, 0, 0, 1};
  const std::string png = palette_png(3, pixels, palette);
  EXPECT_THAT(png, StartsWith(std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x03\0\0\0\x02", 24)));
  EXPECT_THAT(png, HasSubstr(std::string("PLTE\0\0\0\xff\0\x80", 10)));
  EXPECT_THAT(png, HasSubstr("IEND"));
  EXPECT_EQ(in_base64("Man"), "TWFu");
  EXPECT_EQ(in_base64("Ma"), "TWE=");
  EXPECT_EQ(in_base64("M"), "TQ==");
  EXPECT_EQ(in_base64(""), "");
  EXPECT_EQ(in_base64("\xff\xfe\xfd"), "//79");
}

}  // namespace
}  // namespace plumb::lab::stability
