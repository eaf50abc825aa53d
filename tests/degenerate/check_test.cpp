// Does a run ask what it says, find what fails, shrink it, and say so the same way each time?
#include "plumb/degenerate/check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "plumb/degenerate/paste.hpp"
#include "plumb/degenerate/shrink_case.hpp"
#include "plumb/query/kinds/kinds.hpp"

namespace plumb::degenerate {
namespace {

bool same_bits(const Numbers& a, const Numbers& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

double naive_orient2d(const double* a, const double* b, const double* c) {
  return (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0]);
}

const Kind& turns() { return kind_named("orient2d"); }

TEST(Check, SaysTheSameEachTime) {
  const CheckOptions options{.seed = 3, .cases = 300, .keep = 2};
  const Findings once = check(turns(), naive_orient2d, options), again = check(turns(), naive_orient2d, options);
  ASSERT_FALSE(once.clean());
  EXPECT_EQ(text(turns(), once), text(turns(), again));
  EXPECT_NE(text(turns(), once), text(turns(), check(turns(), naive_orient2d, {.seed = 4, .cases = 300, .keep = 2})));
}

TEST(Check, NamesItsCasesSoThatTheyComeAgain) {
  const Findings findings = check(turns(), naive_orient2d, {.seed = 3, .cases = 300});
  for (const Finding& f : findings.findings) {
    EXPECT_TRUE(same_bits(f.found, case_of(turns(), f.generator, 3, f.index))) << f.generator << ' ' << f.index;
    const auto replayed = parse_case(turns(), case_line(turns(), f.smallest));
    ASSERT_TRUE(replayed);
    EXPECT_TRUE(same_bits(*replayed, f.smallest));
    EXPECT_EQ(judge(turns(), *replayed, f.given, {}).sort, f.sort);
  }
  // One generator alone asks the same cases as among others.
  const std::string& last = findings.findings.back().generator;
  const Findings alone = check(turns(), naive_orient2d, {.seed = 3, .cases = 300, .generators = {last}});
  ASSERT_EQ(alone.findings.size(), 1u);
  EXPECT_EQ(alone.findings[0].index, findings.findings.back().index);
  EXPECT_TRUE(same_bits(alone.findings[0].smallest, findings.findings.back().smallest));
}

TEST(Check, TellsEveryOutcome) {
  const auto function = [](std::span<const double> q) -> Answer {
    if (q[0] == 1) return std::numeric_limits<double>::quiet_NaN();
    if (q[0] == 2) throw std::runtime_error("no such point");
    if (q[0] == -1) throw 7;
    if (q[0] == -2) return Answer(Outcome::hung);
    return turns().exact(q);
  };
  const Findings findings = check(turns(), function, {.cases = 500, .generators = {"touching"}, .keep = 9});
  ASSERT_EQ(findings.tallies.size(), 1u);
  const Tally& t = findings.tallies[0];
  EXPECT_EQ(t.asked, 500u);
  EXPECT_GT(t.unsure, 50u);
  EXPECT_GT(t.failed, 150u);
  EXPECT_EQ(t.wrong, 0u);
  ASSERT_EQ(findings.findings.size(), 2u);  // what is unsure is no finding
  for (const Finding& f : findings.findings) {
    EXPECT_TRUE(f.sort == "threw" || f.sort == "hung") << f.sort;
    for (std::size_t i = 1; i < 6; ++i) EXPECT_EQ(f.smallest[i], 0) << text(turns(), findings);
    EXPECT_TRUE(f.repeated);
  }
}

TEST(Check, KeepsWhatFailsOnlyOnce) {
  bool first = true;
  const auto function = [&first](std::span<const double> q) {
    return std::exchange(first, false) ? Answer(Outcome::crashed, "SIGSEGV") : turns().exact(q);
  };
  const Findings findings = check(turns(), function, {.cases = 5});
  ASSERT_EQ(findings.findings.size(), 1u);
  EXPECT_FALSE(findings.findings[0].repeated);
  EXPECT_TRUE(same_bits(findings.findings[0].found, findings.findings[0].smallest));
  EXPECT_EQ(findings.findings[0].given.note, "SIGSEGV");
}

TEST(Check, SaysWhatFailsByChance) {
  std::uint64_t calls = 0;
  const auto function = [&calls](std::span<const double> q) {
    return ++calls % 3 == 0 ? Answer(std::numeric_limits<double>::infinity()) : turns().exact(q);
  };
  const Findings findings = check(turns(), function, {.cases = 40, .keep = 9});
  EXPECT_GT(findings.findings.size(), 10u);
  for (const Finding& f : findings.findings)
    EXPECT_LE(f.repeated, judge(turns(), f.smallest, f.given, {}).sort == f.sort) << text(turns(), findings);
}

TEST(Check, JudgesInTheCallersRoundingMode) {
  const auto function = [](std::span<const double> q) {
    const Answer answer = turns().exact(q);
    std::fesetround(FE_UPWARD);
    return answer;
  };
  EXPECT_TRUE(check(turns(), function, {.cases = 100}).clean());
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
}

TEST(Check, IsCleanOnlyWhereNothingFails) {
  const Findings findings = check(turns(), naive_orient2d, {.cases = 300, .keep = 0});
  EXPECT_TRUE(findings.findings.empty());
  EXPECT_FALSE(findings.clean());
}

TEST(Check, AsksTheCorpusFirstAndMutatesIt) {
  const Numbers known{1, 2, 3, 4, 5, 7};
  std::vector<Numbers> asked;
  const auto function = [&](std::span<const double> q) {
    asked.emplace_back(q.begin(), q.end());
    return turns().exact(q);
  };
  const Findings findings =
      check(turns(), function, {.cases = 40, .generators = {"mutated"}, .corpus = {known}, .block = 16});
  EXPECT_TRUE(findings.clean());
  ASSERT_EQ(asked.size(), 41u);
  EXPECT_TRUE(same_bits(asked[0], known));
  int near = 0;
  for (const Numbers& q : asked) near += std::ranges::count(q, 7.0) > 0 ? 1 : 0;
  EXPECT_GE(near, 8);  // half of them start from the corpus, and most moves leave the 7 alone
  EXPECT_EQ(findings.tallies[0].generator, corpus_generator);
  EXPECT_EQ(findings.tallies[0].asked, 1u);
}

TEST(Check, StopsWhenToldAndWhenTheTimeIsUp) {
  std::uint64_t told = 0;
  const CheckOptions until_told{.cases = 0, .seconds = 100, .progress = [&](const Findings& f) {
                                  told = f.asked();
                                  return f.asked() < 2000;
                                }};
  const Findings stopped = check(turns(), turns().exact, until_told);
  EXPECT_EQ(stopped.asked(), told);
  EXPECT_LT(told, 2300u);
  EXPECT_GT(check(turns(), turns().exact, {.cases = 0, .seconds = 0.01}).asked(), 0u);
}

TEST(Check, FindsAndShrinksWithinTheDomain) {
  const Domain near{.largest = 1000, .smallest = 1e-3};
  const Findings findings = check(turns(), naive_orient2d, {.cases = 300, .domain = near});
  ASSERT_FALSE(findings.clean());
  for (const Finding& f : findings.findings) {
    EXPECT_TRUE(is_in(near, turns(), f.found)) << f.generator;
    EXPECT_TRUE(is_in(near, turns(), f.smallest)) << f.generator;
    EXPECT_TRUE(same_bits(f.found, case_of(turns(), f.generator, findings.seed, f.index, {}, near))) << f.generator;
  }
  EXPECT_TRUE(check(turns(), naive_orient2d, {.cases = 1000, .domain = {.largest = 1e6, .grid = 1}}).clean());
  const Findings proper = check(turns(), naive_orient2d, {.cases = 300, .domain = {.degenerate = false}});
  for (const Finding& f : proper.findings) EXPECT_NE(f.exact.numbers[0], 0) << f.sort;
}

TEST(Domain, KeepsWhatIsExactlyDegenerateWhereThereIsRoom) {
  const Domain small{.largest = 1000, .grid = 0x1p-20};
  int flat = 0;
  for (std::uint64_t i = 0; i < 100; ++i) {
    const Numbers q = case_of(turns(), "degenerate_short", 3, i);
    const auto within = fitted(small, turns(), q);
    ASSERT_TRUE(within);
    EXPECT_TRUE(is_in(small, turns(), *within));
    flat += turns().exact(*within).numbers[0] == 0 ? 1 : 0;
    EXPECT_TRUE(same_bits(*fitted(small, turns(), *within), *within));
    EXPECT_TRUE(same_bits(*fitted({}, turns(), q), q));
  }
  EXPECT_EQ(flat, 100);
  EXPECT_FALSE(fitted({.degenerate = false}, turns(), Numbers{0, 0, 1, 1, 2, 2}));
  EXPECT_EQ(fitted({.largest = 3}, turns(), {4, 0, 1, 0x1p-1074, -8, 0}), (Numbers{1, 0, 0.25, 0, -2, 0}));
  EXPECT_EQ(fitted({.largest = 2.5, .bits = 2}, turns(), {2.5, 0, 1.25, 0.875, 0, 0}), (Numbers{2, 0, 1, 1, 0, 0}));
}

TEST(Domain, IsRefusedWhereItMakesNoSense) {
  for (const Domain& d :
       {Domain{.largest = 0}, Domain{.largest = HUGE_VAL}, Domain{.largest = NAN}, Domain{.largest = 1, .smallest = 2},
        Domain{.smallest = -1}, Domain{.smallest = NAN}, Domain{.largest = 7, .smallest = 5, .grid = 4},
        Domain{.largest = 7, .smallest = 5, .bits = 1}, Domain{.grid = 0.1}, Domain{.largest = 1, .grid = 2},
        Domain{.grid = NAN}, Domain{.bits = 0}, Domain{.bits = 54}})
    EXPECT_THROW(check(turns(), turns().exact, {.domain = d}), Error);
}

TEST(Check, PassesOverTheCorpusBeyondTheDomain) {
  const Findings findings = check(turns(), turns().exact,
                                  {.cases = 1,
                                   .generators = {"grid"},
                                   .corpus = {{1, 2, 3, 4, 5, 7}, {0.5, 2, 3, 4, 5, 7}},
                                   .domain = {.grid = 1}});
  EXPECT_EQ(findings.tallies[0].generator, corpus_generator);
  EXPECT_EQ(findings.tallies[0].asked, 1u);
}

TEST(Check, RefusesWhatItCannotAsk) {
  const auto refused = [](const CheckOptions& options) -> std::string {
    try {
      check(turns(), turns().exact, options);
    } catch (const Error& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_NE(refused({.generators = {"gird"}}).find("orient2d has no generator gird; it has grid"), std::string::npos);
  EXPECT_EQ(refused({.cases = 0}), "check: neither cases nor seconds; give either");
  EXPECT_EQ(refused({.block = 0}), "check: a block of 0 cases; ask at least one at once");
  EXPECT_EQ(refused({.corpus = {{1, 2, 3}}}), "check: corpus: orient2d: b lacks numbers");
}

TEST(Judge, TellsSigns) {
  const Numbers left{0, 0, 1, 0, 0, 1}, flat{0, 0, 1, 0, 2, 0};
  const auto sort = [](const Numbers& q, double given) { return std::string(judge(turns(), q, given, {}).sort); };
  EXPECT_EQ(sort(left, 1e-300), "");
  EXPECT_EQ(sort(left, 0), "0 for +");
  EXPECT_EQ(sort(left, -HUGE_VAL), "- for +");
  EXPECT_EQ(sort(flat, -0.0), "");
  EXPECT_EQ(sort(flat, 5e-324), "+ for 0");
  EXPECT_EQ(sort({left[4], left[5], 1, 0, 0, 0}, 2), "+ for -");
  EXPECT_EQ(judge(turns(), left, std::numeric_limits<double>::quiet_NaN(), {}).verdict, Verdict::unsure);
  EXPECT_EQ(judge(turns(), left, Answer(), {}).verdict, Verdict::failed);
}

TEST(Judge, AllowsWhatTheToleranceAllows) {
  const Kind& kind = kind_named("convex-distance");
  const Numbers apart{1, 0, 0, 0, 1, 3, 4, 0}, meeting{1, 0, 0, 0, 1, 0, 0, 0};
  const auto sort = [&](const Numbers& q, double given, const Tolerance& tolerance) {
    return std::string(judge(kind, q, given, tolerance).sort);
  };
  const double ulp = 0x1p-50;  // of 5
  EXPECT_EQ(sort(apart, 5, {}), "");
  EXPECT_EQ(sort(apart, 5 + ulp, {}), "too large");
  EXPECT_EQ(sort(apart, 5 + 3 * ulp, {.ulps = 3}), "");
  EXPECT_EQ(sort(apart, 5 + 4 * ulp, {.ulps = 3}), "too large");
  EXPECT_EQ(sort(apart, 5 - 4 * ulp, {.ulps = 3}), "too small");
  EXPECT_EQ(sort(apart, 5 + 0x1p-18, {.relative = 0x1p-20}), "");  // of 4, the largest coordinate
  EXPECT_EQ(sort(apart, 5 + 0x1p-18 + ulp, {.relative = 0x1p-20}), "too large");
  EXPECT_EQ(sort(meeting, 5e-324, {.relative = 0.5}), "too large");  // of points at the origin there is no size
  EXPECT_EQ(sort(apart, HUGE_VAL, {.ulps = ~0ull}), "too large");

  const Kind& hits = kind_named("ray-triangle");
  const Numbers ray{0, 0, -1, 0, 0, 2, -1, -1, 0, 1, -1, 0, 0, 1, 0};
  const auto at = [](double t) {
    Answer answer = 1.0;
    answer.numbers.push_back(t);
    return answer;
  };
  EXPECT_EQ(judge(hits, ray, at(0.5), {}).sort, "");
  EXPECT_EQ(judge(hits, ray, 1.0, {}).sort, "");
  EXPECT_EQ(judge(hits, ray, 0.0, {}).sort, "no for yes");
  EXPECT_EQ(judge(hits, ray, at(0.75), {}).sort, "parameter too large");
  EXPECT_EQ(judge(hits, ray, at(-0.5), {}).sort, "parameter too small");
  EXPECT_EQ(judge(hits, ray, at(std::numeric_limits<double>::quiet_NaN()), {}).sort, "hit without a parameter");
}

TEST(Case, SaysWhatIsWrongWithIt) {
  const auto flaw = [](const char* kind, const Numbers& numbers) { return flaw_of(kind_named(kind), numbers); };
  EXPECT_EQ(flaw("orient2d", {1, 2, 3, 4, 5, 6}), "");
  EXPECT_EQ(flaw("orient2d", {1, 2, 3, 4, 5, 6, 7}), "orient2d: numbers too many: 1");
  EXPECT_EQ(flaw("orient2d", {1, 2, 3, 4, 5, HUGE_VAL}), "orient2d: a number is not finite");
  EXPECT_EQ(flaw("point-in-polygon", {0, 0}), "point-in-polygon: vertices lacks its count of points");
  EXPECT_EQ(flaw("point-in-polygon", {0, 0, 1.5}),
            "point-in-polygon: vertices begins with 0x1.8p+0, which is no count of points");
  EXPECT_EQ(flaw("point-in-polygon", {0, 0, 2, 0, 0, 1, 1}), "point-in-polygon: vertices takes at least 3 points");
  EXPECT_EQ(flaw("hull", {1e300, 0, 0, 0}), "hull: points lacks numbers");
  EXPECT_EQ(flaw("box-box", {0, 0, 2, 1, 1, 1, 0, 0, 0, 1, 1, 1}), "box-box: a has its corners out of order");
  Numbers boxes(30);
  EXPECT_EQ(flaw("obb-obb", boxes), "");
  boxes[29] = -1;
  EXPECT_EQ(flaw("obb-obb", boxes), "obb-obb: b has a negative length");
}

/// A tetrahedron about the point, and one of its corners by another number.
const Numbers in_tetrahedron{1, 1,    1, 5, 0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 4,
                             0, -0.0, 4, 4, 0, 2, 1, 0, 1, 3, 1, 2, 4, 2, 0, 4};

TEST(Case, OfAMeshNamesItsPointsAndCloses) {
  const Kind &solid = kind_named("point-in-polyhedron"), &soup = kind_named("ray-mesh");
  const auto flaw = [&](std::size_t at, double x) {
    Numbers numbers = in_tetrahedron;
    numbers[at] = x;
    return flaw_of(solid, numbers);
  };
  EXPECT_EQ(flaw_of(solid, in_tetrahedron), "");
  EXPECT_EQ(solid.exact(in_tetrahedron).numbers[0], 1);
  EXPECT_EQ(flaw(20, 5), "point-in-polyhedron: triangles name a point that is not there");
  EXPECT_EQ(flaw(20, -1), "point-in-polyhedron: triangles name a point that is not there");
  EXPECT_EQ(flaw(20, 0.5), "point-in-polyhedron: triangles name a point that is not there");
  EXPECT_EQ(flaw(20, 1), "point-in-polyhedron: triangles do not close");
  EXPECT_EQ(flaw(17, 1), "point-in-polyhedron: triangles do not close");  // places count, not indices
  EXPECT_EQ(flaw(19, 5), "point-in-polyhedron: triangles lacks numbers");
  EXPECT_EQ(flaw(19, 0), "point-in-polyhedron: triangles takes at least 1 triangles");
  Numbers open{0, 0, 1, 0, 0, -1, 3, 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 1, 2};
  EXPECT_EQ(flaw_of(soup, open), "");
  EXPECT_FALSE(is_degenerate(soup, open));
  open[18] = 0;
  EXPECT_EQ(flaw_of(soup, open), "");
  EXPECT_TRUE(is_degenerate(soup, open));
  EXPECT_FALSE(is_degenerate(solid, in_tetrahedron));
  Numbers flat = in_tetrahedron;
  flat[15] = flat[18] = 0;
  EXPECT_EQ(flaw_of(solid, flat), "");
  EXPECT_TRUE(is_degenerate(solid, flat));
}

TEST(Case, OfAMeshIsReadyToPaste) {
  const Kind& soup = kind_named("ray-mesh");
  const Numbers numbers{0, 0, 1, 0, 0, -2, 3, 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 1, 2};
  EXPECT_EQ(decimal_text(soup, numbers),
            "ray = (0, 0, 1) (0, 0, -2)\nvertices = (0, 0, 0) (1, 0, 0) (0, 1, 0)\ntriangles = (0, 1, 2)");
  const std::string cpp = cpp_text(soup, numbers, "mine");
  for (const char* part : {"const size_t triangles[] = {0, 1, 2};", "mine(ray, vertices, 3, triangles, 1, &t), 0);",
                           "EXPECT_DOUBLE_EQ(t, 0x1p-1);"})
    EXPECT_NE(cpp.find(part), std::string::npos) << cpp;
  EXPECT_NE(python_text(soup, numbers, "mine").find("\ntriangles = [0, 1, 2]\nEXACT = float.fromhex"),
            std::string::npos);
  const std::string obj = obj_text(soup, numbers);
  EXPECT_EQ(obj.substr(obj.find('\n') + 1),
            "o ray\nv 0 0 1\nv 0 0 -1\nl 1 2\no vertices\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 3 4 5\n");
}

TEST(Case, IsReadAndWrittenForEveryKind) {
  for (const Kind& kind : kinds()) {
    for (const Generator& g : kind.generators) {
      const Numbers numbers = case_of(kind, g.name, 1, 0);
      const std::string line = case_line(kind, numbers);
      const auto read = parse_case(kind, line + "  # a remark");
      ASSERT_TRUE(read) << line;
      EXPECT_TRUE(same_bits(*read, numbers)) << line;
      EXPECT_NE(cpp_text(kind, numbers, "mine").find("mine("), std::string::npos);
    }
    const Numbers numbers = case_of(kind, kind.generators[0].name, 1, 0);
    const std::string line = case_line(kind, numbers), bare = line.substr(0, line.find('='));
    EXPECT_TRUE(parse_case(kind, bare)) << line;
    EXPECT_TRUE(parse_case(kind, bare + "# = remark")) << line;
    for (const char* other : {"=", "= maybe", "= + +", "= yes no", "= = 1", "== 1", "= 1 2", "= yes at", "= triangles"})
      EXPECT_THROW(parse_case(kind, bare + other), Error) << bare << other;
    EXPECT_FALSE(parse_case(kind, "  # remark"));
    EXPECT_FALSE(parse_case(kind, "another-kind 1 2 3"));
    EXPECT_THROW(parse_case(kind, std::string(kind.name) + " 1"), Error);
    EXPECT_THROW(parse_case(kind, std::string(kind.name) + " one"), Error);
  }
}

TEST(Case, IsReadyToPaste) {
  const Kind& kind = turns();
  const Numbers numbers{0, 0, 1, 0, 0.5, 0.25};
  EXPECT_EQ(decimal_text(kind, numbers), "a = (0, 0)\nb = (1, 0)\nc = (0.5, 0.25)");
  EXPECT_EQ(case_line(kind, numbers), "orient2d 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x1p-1 0x1p-2 = +");
  const std::string cpp = cpp_text(kind, numbers, "my_turn");
  for (const char* part :
       {"extern \"C\" double my_turn(const double a[2], const double b[2], const double c[2]);", "TEST(Orient2d, Case",
        "const double c[] = {0x1p-1, 0x1p-2};  // 0.5, 0.25", "EXPECT_GT(my_turn(a, b, c), 0);"}) {
    EXPECT_NE(cpp.find(part), std::string::npos) << cpp;
  }
  const std::string python = python_text(kind, numbers, "my_turn", {.library = "./libmine.so"});
  for (const char* part :
       {"#!/usr/bin/env python3\n# orient2d: which way do three points turn?\n", "else \"./libmine.so\"\n",
        "\nSYMBOL = \"my_turn\"\n", "\nc = [float.fromhex(x) for x in \"0x1p-1 0x1p-2\".split()]  # 0.5, 0.25\n",
        "\nEXACT = 1  # +\n"}) {
    EXPECT_NE(python.find(part), std::string::npos) << python;
  }
  EXPECT_EQ(obj_text(kind_named("segment-segment"), Numbers{0, 0, 1, 1, 0, 1, 1, 0}),
            "# segment-segment 0x0p+0 0x0p+0 0x1p+0 0x1p+0 0x0p+0 0x1p+0 0x1p+0 0x0p+0 = yes\n"
            "o a\nv 0 0 0\nv 1 1 0\nl 1 2\no b\nv 0 1 0\nv 1 0 0\nl 3 4\n");
  const std::string boxes = obj_text(kind_named("box-box"), Numbers{0, 0, 0, 1, 1, 1, 0, 0, 0, 1, 1, 1});
  EXPECT_EQ(std::ranges::count(boxes, 'v'), 16);
  EXPECT_EQ(std::ranges::count(boxes, 'f'), 12);
  const std::string ray =
      cpp_text(kind_named("ray-triangle"), Numbers{0, 0, -1, 0, 0, 2, -1, -1, 0, 1, -1, 0, 0, 1, 0}, "mine");
  EXPECT_NE(ray.find("EXPECT_NE(mine(ray, triangle, &t), 0);\n  EXPECT_DOUBLE_EQ(t, 0x1p-1);"), std::string::npos);
  // What is beyond all doubles no reader takes.
  Numbers huge(30, 0x1p1023);
  for (const Numbers& far : {huge, Numbers(huge.begin(), huge.begin() + 15)}) {
    const std::string obj = obj_text(kind_named(far.size() == 30 ? "obb-obb" : "ray-triangle"), far);
    EXPECT_EQ(obj.find("inf"), std::string::npos) << obj;
    EXPECT_EQ(obj.find("nan"), std::string::npos) << obj;
  }
}

// A failure that needs three vertices in a triangle of at least some size, far from the origin.
TEST(ShrinkCase, DropsAndMergesPointsAndTurnsAxes) {
  const Kind& kind = kind_named("point-in-polygon");
  const auto tall = [](std::span<const double> q) {
    double low = 0, high = 0;
    for (std::size_t i = 4; i < q.size(); i += 2) {
      low = std::min(low, q[i]);
      high = std::max(high, q[i]);
    }
    return high - low > 5;
  };
  const Numbers shrunk = shrink_case(kind, {3.25, 1e9, 5, 0.1, 0.2, 17.3, -400, 33, 22, 1e-3, 1e5, 1, 2}, tall);
  EXPECT_EQ(shrunk[2], 3);
  EXPECT_EQ(shrunk.size(), 9u);
  EXPECT_TRUE(tall(shrunk));
  EXPECT_EQ(std::ranges::count_if(shrunk, [](double x) { return x != 0; }), 3) << decimal_text(kind, shrunk);

  const Kind& boxes = kind_named("obb-obb");
  const auto wide = [](std::span<const double> q) { return q[27] > 1; };
  Numbers large = case_of(boxes, "stacked", 8, 0);
  large[27] = 77.7;
  const Numbers simple = shrink_case(boxes, large, wide);
  EXPECT_EQ(std::vector(simple.begin() + 3, simple.begin() + 12), (std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1}));
  EXPECT_EQ(std::vector(simple.begin() + 18, simple.begin() + 27), (std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1}));
  EXPECT_GT(simple[27], 1);
  EXPECT_LE(simple[27], 4);
}

// What fails wherever a mesh is as wide as this: of any mesh a tetrahedron is left, of triangles one.
TEST(ShrinkCase, LosesTrianglesAndKeepsSurfacesClosed) {
  const auto wide = [](std::span<const double> q, std::size_t at) {
    double low = 0, high = 0;
    for (std::size_t i = at + 1; i < at + 1 + 3 * static_cast<std::size_t>(q[at]); i += 3) {
      low = std::min(low, q[i]);
      high = std::max(high, q[i]);
    }
    return high - low > 5;
  };
  for (const Kind* kind : {&kind_named("point-in-polyhedron"), &kind_named("ray-mesh")}) {
    const bool solid = kind->name == "point-in-polyhedron";
    const std::size_t at = solid ? 3 : 6;
    const auto fails = [&](std::span<const double> q) {
      EXPECT_EQ(flaw_of(*kind, q), "");
      return wide(q, at);
    };
    int shrunk = 0;
    for (const Generator& g : kind->generators) {
      const Numbers numbers = case_of(*kind, g.name, 4, 2);
      if (!wide(numbers, at) || is_degenerate(*kind, numbers)) continue;
      ++shrunk;
      const Numbers least = shrink_case(*kind, numbers, fails);
      EXPECT_EQ(least[at], solid ? 4 : 3) << g.name << '\n' << decimal_text(*kind, least);
      EXPECT_EQ(least[at + 1 + 3 * static_cast<std::size_t>(least[at])], solid ? 4 : 1) << g.name;
    }
    EXPECT_GE(shrunk, 8);
  }
}

TEST(Mutated, CasesAreCases) {
  for (const Kind& kind : kinds()) {
    std::size_t longest = 0, shortest = 1000;
    for (std::uint64_t i = 0; i < 300; ++i) {
      const Numbers numbers = case_of(kind, mutated_generator, 6, i);
      ASSERT_EQ(flaw_of(kind, numbers), "") << i;
      longest = std::max(longest, numbers.size());
      shortest = std::min(shortest, numbers.size());
    }
    const bool any_number = std::ranges::any_of(kind.arguments, [](const Argument& a) { return a.any_number(); });
    EXPECT_EQ(longest > shortest, any_number) << kind.name;
  }
}

}  // namespace
}  // namespace plumb::degenerate
