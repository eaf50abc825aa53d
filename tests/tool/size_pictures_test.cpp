// tests/bench/report/growth.py and sizes.py: what bench_growth and bench_sizes measured, as pictures and as tables.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <vector>

#include "tool/matchers.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

json measured(std::uint64_t triangles, const std::string& what, double ns) {
  return {{"name", "growth/" + std::to_string(triangles) + "/" + what},
          {"run_type", "iteration"},
          {"ns", ns},
          {"bytes", 57.5},
          {"peak", 200.0 * double(triangles)}};
}

json sample() {
  json run{{"context", {{"date", "2026-01-02T03:04:05+00:00"}}}, {"benchmarks", json::array()}};
  for (const std::uint64_t n : {1024U, 10000U, 9998244U}) {
    for (const double ns : {300.0, 280.0, 290.0}) run["benchmarks"].push_back(measured(n, "build_binned", ns));
    run["benchmarks"].push_back(measured(n, "rays_random", n == 1024U ? 80 : 1234.5));
  }
  json aggregate = measured(1024, "build_binned", 1e9);
  aggregate["run_type"] = "aggregate";
  run["benchmarks"].push_back(aggregate);
  return run;
}

Outcome drawn(const std::string& text, const std::string& options = "", const std::string& by = "growth.py") {
  return run("python3 " PLUMB_SOURCE_DIR "/tests/bench/report/" + by + ' ' + options, text);
}

/// The places of the markers of one curve, from left to right: y grows downward.
std::vector<double> heights_of(const std::string& svg, const std::string& curve) {
  std::vector<double> heights;
  const std::regex marker("data-curve=\"" + curve + "\" cx=\"([0-9.]+)\" cy=\"([0-9.]+)\"");
  double last = 0;
  for (std::sregex_iterator i(svg.begin(), svg.end(), marker), end; i != end; ++i) {
    EXPECT_GT(std::stod((*i)[1]), last);
    last = std::stod((*i)[1]);
    heights.push_back(std::stod((*i)[2]));
  }
  return heights;
}

TEST(GrowthPicture, HasEveryFigureWhereItBelongs) {
  const Outcome o = drawn(sample().dump());
  ASSERT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(o.out, testing::AllOf(testing::StartsWith("<svg"), testing::EndsWith("</svg>\n"),
                                    testing::HasSubstr("2026-01-02"), testing::HasSubstr("build, binned: 290 at 1,024"),
                                    testing::HasSubstr("1,234 at 9,998,244"), testing::HasSubstr("57.5 at 10,000"),
                                    testing::HasSubstr("dark")));
  const std::vector<double> flat = heights_of(o.out, "build, binned"),
                            rising = heights_of(o.out, "random rays, together");
  ASSERT_EQ(flat.size(), 3U);
  EXPECT_EQ(flat[0], flat[2]);
  ASSERT_EQ(rising.size(), 3U);
  EXPECT_LT(rising[1], rising[0]);
  const std::string peak = "most while it is built .binned.";
  EXPECT_EQ(heights_of(o.out, peak).size(), 3U);
  EXPECT_GT(heights_of(o.out, "the tree, mesh included")[0], heights_of(o.out, peak)[0]);
  EXPECT_EQ(heights_of(o.out, "build, linear").size(), 0U);  // was not measured
  EXPECT_EQ(run("python3 -c 'import sys, xml.dom.minidom as m; m.parse(sys.stdin)'", o.out).code, 0);
}

TEST(GrowthPicture, IsATableAsWell) {
  const Outcome o = drawn(sample().dump(), "--table");
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_EQ(o.out,
            "| triangles | 1,024 | 10,000 | 9,998,244 |\n| --- | ---: | ---: | ---: |\n"
            "| build, binned: ns a triangle | 290 | 290 | 290 |\n"
            "| random rays, together: ns a ray | 80 | 1,234 | 1,234 |\n"
            "| the tree, mesh included: bytes a triangle | 57.5 | 57.5 | 57.5 |\n"
            "| most while it is built (binned): bytes a triangle | 200 | 200 | 200 |\n");
}

TEST(GrowthPicture, HasAFamilyOfCrowds) {
  json run{{"benchmarks", json::array()}};
  for (const int n : {1000, 10000}) {
    const std::string name = "pairs_growth/" + std::to_string(n) + "/box_tree";
    run["benchmarks"].push_back({{"name", name}, {"ns", 50}, {"peak", 30 * n}});
  }
  EXPECT_EQ(drawn(run.dump(), "pairs_growth --table").out,
            "| boxes | 1,000 | 10,000 |\n| --- | ---: | ---: |\n| box tree: ns a box | 50 | 50 |\n"
            "| box tree: bytes a box | 30 | 30 |\n");
  const Outcome picture = drawn(run.dump(), "pairs_growth");
  EXPECT_THAT(picture.out, testing::HasSubstr("box tree: 50 at 10,000"));
  EXPECT_EQ(tool::run("python3 -c 'import sys, xml.dom.minidom as m; m.parse(sys.stdin)'", picture.out).code, 0);
  EXPECT_NE(drawn(run.dump(), "points_growth").code, 0);  // of which there is none
  EXPECT_NE(drawn(run.dump(), "no_growth").code, 0);
}

json sizes() {
  json run{{"benchmarks", json::array()}};
  for (const double n : {10.0, 100.0, 1000.0}) {
    const std::string at = "/" + std::to_string(static_cast<int>(n)) + "/";
    for (const double off : {0.5, 1.0, 1.5}) {
      run["benchmarks"].push_back({{"name", "sizes/polygon" + at + "plumb"}, {"ns", 3 * n * off}});
      run["benchmarks"].push_back({{"name", "sizes/hull2" + at + "qhull"}, {"ns", 50 * off}});
    }
  }
  run["benchmarks"].push_back({{"name", "sizes/hull2/10/cgal"}, {"ns", 70}});
  return run;
}

TEST(SizesPicture, SaysWithWhichPowerTimesGrow) {
  const Outcome o = drawn(sizes().dump(), "", "sizes.py");
  ASSERT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(o.out, testing::AllOf(testing::StartsWith("<svg"), testing::HasSubstr("plumb n^1.00: 300 at 100<"),
                                    testing::HasSubstr("qhull n^1.00: 50 at 10<"), testing::HasSubstr("cgal : 70 at")));
  EXPECT_EQ(heights_of(o.out, "plumb n.1.00").size(), 3U);
  EXPECT_EQ(run("python3 -c 'import sys, xml.dom.minidom as m; m.parse(sys.stdin)'", o.out).code, 0);
  EXPECT_THAT(drawn(sizes().dump(), "--table", "sizes.py").out,
              testing::HasSubstr("| 10 | 100 | 1,000 | grows as |\n| --- | ---: | ---: | ---: | ---: |\n"
                                 "| plumb | 30 | 300 | 3,000 | n^1.00 |\n"));
}

TEST(GrowthPicture, RefusesWhatItIsNotMadeOf) {
  for (const std::string text : {"", "{}", "[]", R"({"benchmarks": []})", R"({"benchmarks": [{"name": "growth/x/y"}]})",
                                 R"({"benchmarks": [{"name": "sizes/hull2/x/y", "ns": 1}]})",
                                 R"({"benchmarks": [{"name": "other/1/y", "ns": 1}]})"}) {
    for (const std::string by : {"growth.py", "sizes.py"}) {
      const Outcome o = drawn(text, "", by);
      EXPECT_NE(o.code, 0) << text;
      EXPECT_THAT(o.err, testing::StartsWith(by + ": ")) << text;
      EXPECT_EQ(o.out, "") << text;
    }
  }
}

}  // namespace
}  // namespace plumb::tool
