// What the laboratory finds: exact methods fail nothing, the usual ones fail where textbooks say that they do, and the
// parts that count can tell.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "plumb/degenerate/cloud.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/figure/hull2.hpp"
#include "tool/stability/experiment.hpp"
#include "tool/stability/hull_judge.hpp"
#include "tool/stability/png.hpp"
#include "tool/stability/segment_methods.hpp"
#include "tool/stability/sweep.hpp"

namespace plumb::tool::stability {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using Sums = std::map<std::string, std::uint64_t>;  // of failures, by method and the failure's name

struct Found {
  Sums failures;
  std::set<std::string> pictures;
};

/// Runs an experiment quickly, and expects what holds for all.
Found found_by(const Experiment& experiment, std::uint64_t start = 2026) {
  Settings settings;
  settings.quick = true;
  settings.seed = start;
  Found found;
  std::set<std::string> scenes;
  for (const Scene& scene : experiment.scenes(settings)) {
    EXPECT_TRUE(scenes.insert(scene.name).second) << scene.name;
    const Findings findings = scene.run();
    EXPECT_FALSE(findings.outcomes.empty());
    std::uint64_t tried_exactly = 0;
    for (const MethodOutcome& o : findings.outcomes) {
      EXPECT_EQ(o.counts.size(), findings.outcomes[0].counts.size());
      for (std::size_t i = 0; i < o.counts.size(); ++i) {
        const Count& c = o.counts[i];
        EXPECT_EQ(c.failure, findings.outcomes[0].counts[i].failure);
        EXPECT_LE(c.failures, c.of) << scene.name << ' ' << o.method;
        if (o.exact) {
          EXPECT_EQ(c.failures, 0U) << scene.name << ' ' << o.method << ": " << c.failure << ", start " << start;
          tried_exactly += c.of;
        }
        found.failures[o.method + ": " + c.failure] += c.failures;
      }
    }
    EXPECT_GT(tried_exactly, 0U) << scene.name;
    for (const Picture& p : findings.pictures) {
      EXPECT_TRUE(found.pictures.insert(p.name).second) << p.name;
      EXPECT_THAT(p.svg, StartsWith("<svg"));
      EXPECT_THAT(p.svg, HasSubstr("</svg>"));
      EXPECT_NE(p.caption, "");
    }
  }
  return found;
}

TEST(Grid, ShowsFloatsOnTheWrongSideAndOffTheLine) {
  const Found found = found_by(grid_experiment());
  EXPECT_EQ(found.pictures.size(), 10U);
  const Sums& f = found.failures;
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

TEST(Segments, AreMissedInFloatingPointAndCrossOnNeither) {
  const Found found = found_by(segment_experiment());
  const Sums& f = found.failures;
  EXPECT_GT(f.at("double: pairs that meet and are said not to"), 0U);
  EXPECT_GT(f.at("double: pairs answered otherwise when swapped or reversed"), 0U);
  EXPECT_GT(f.at("double: crossing points that lie on neither segment"), 0U);
  EXPECT_GT(f.at("double: crossing points that are not the nearest doubles"), 0U);
  EXPECT_GT(f.at("double: segments through the shared end that are said to miss both"), 0U);
  EXPECT_GT(f.at("double: segments through the shared end that are said to meet one and miss the other"), 0U);
}

TEST(Sweeps, LoseAndInventPairsInFloatingPoint) {
  const Found found = found_by(sweep_experiment());
  EXPECT_GT(found.failures.at("double: pairs that meet and were lost"), 0U);
  EXPECT_GT(found.failures.at("float32: pairs that do not meet and were reported"), 0U);
}

TEST(Experiments, AreExactForOtherInputsAsWellAndRepeatable) {
  for (const Experiment& e : {hull_experiment(), segment_experiment(), sweep_experiment()}) {
    const Sums other = found_by(e, 7).failures;
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
  const HullMethod& exact = hull_methods().back();
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
    std::vector<Segment<Rational>> exact;
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
}  // namespace plumb::tool::stability
