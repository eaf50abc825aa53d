// Laws 1 and 2 of degenerate/rapidcheck.hpp, in RapidCheck's own hands, and those of degenerate/fuzz_target.hpp.
#include "plumb/degenerate/rapidcheck.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>
#include <sstream>

#include "plumb/degenerate/fuzz_target.hpp"
#include "plumb/query/kinds/kinds.hpp"

namespace {

using plumb::Point2, plumb::Degeneracy;
using Points = std::vector<Point2>;

// Greedy descent as RapidCheck does it: the first shrink that still fails is the next to shrink.
template <class T, class Fails>
T shrunk(rc::Shrinkable<T> failing, const Fails& fails, int& steps) {
  for (bool improved = true; improved;) {
    improved = false;
    auto candidates = failing.shrinks();
    while (auto candidate = candidates.next()) {
      if (!fails(candidate->value())) continue;
      failing = *candidate;
      improved = true;
      ++steps;
      break;
    }
  }
  return failing.value();
}

TEST(RapidCheckBridge, FailingPropertyShrinksToASmallCase) {
  const auto generator = plumb::any_points2(Degeneracy::collinear, 3);
  const auto fails = [](const Points& p) { return std::fabs(p[1].y) > 100; };
  int found = 0, least_possible = 0;
  for (std::uint64_t i = 0; i < 60; ++i) {
    const auto made = generator(rc::Random(i), 100);
    if (!fails(made.value())) continue;
    ++found;
    int steps = 0;
    const Points least = shrunk(made, fails, steps);
    ASSERT_TRUE(fails(least));
    // Whatever the family it came from: numbers just above what fails, beside others no larger.
    for (const Point2& p : least) EXPECT_LE(std::max(std::fabs(p.x), std::fabs(p.y)), 128);
    least_possible += least == Points{{0, 0}, {0, 101}, {0, 0}};
    EXPECT_GT(steps, 0);
  }
  EXPECT_GT(found, 10);
  EXPECT_GE(2 * least_possible, found);
}

TEST(RapidCheckBridge, RapidCheckReportsTheSmallCase) {
  rc::detail::TestParams parameters;
  parameters.seed = 1;
  const auto result = rc::detail::checkTestable(
      [] {
        const Points p = *plumb::any_points2(Degeneracy::cocircular, 4);
        RC_ASSERT(std::fabs(p[0].x) < 7);
      },
      rc::detail::TestMetadata(), parameters);
  rc::detail::FailureResult failure;
  ASSERT_TRUE(result.match(failure));
  std::string shown;
  for (const auto& [type, value] : failure.counterExample) shown += value;
  EXPECT_EQ(shown, "[(0x1.cp+2 0x0p+0), (0x0p+0 0x0p+0), (0x0p+0 0x0p+0), (0x0p+0 0x0p+0)]");
}

TEST(RapidCheckBridge, SameRandomSameCaseAndCasesVary) {
  const auto generator = plumb::any_points2(Degeneracy::collinear, 3);
  std::set<std::uint64_t> seen;
  for (std::uint64_t i = 0; i < 200; ++i) {
    const Points p = generator(rc::Random(i), 100).value(), again = generator(rc::Random(i), 100).value();
    ASSERT_EQ(p, again);
    for (const Point2& q : p) ASSERT_TRUE(std::isfinite(q.x) && std::isfinite(q.y));
    seen.insert(std::bit_cast<std::uint64_t>(p[0].x) ^ std::bit_cast<std::uint64_t>(p[2].y) * 3);
  }
  EXPECT_GT(seen.size(), 180u);
}

TEST(RapidCheckBridge, CasesOfAKindAreCasesAndPairsVary) {
  namespace hard = plumb::degenerate;
  const auto& kind = hard::kind_named("triangle-triangle");
  const auto cases = hard::any_case(kind);
  const auto pairs = hard::any_pair(hard::ShapeKind::segment, hard::ShapeKind::aabb, 3);
  std::set<double> seen;
  for (std::uint64_t i = 0; i < 100; ++i) {
    ASSERT_EQ(hard::flaw_of(kind, cases(rc::Random(i), 100).value()), "");
    seen.insert(pairs(rc::Random(i), 100).value().a[0]);
  }
  EXPECT_GT(seen.size(), 60u);
}

double naive_orient2d(const double* a, const double* b, const double* c) {
  return (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0]);
}

TEST(FuzzTarget, BytesStandForCasesAndBack) {
  for (const auto& kind : plumb::degenerate::kinds()) {
    const auto seeds = plumb::degenerate::fuzz_seeds(kind, 5);
    ASSERT_EQ(seeds.size(), 5 * kind.generators.size());
    for (std::size_t i = 0; i < seeds.size(); ++i) {
      const auto numbers = plumb::degenerate::numbers_from(kind, seeds[i]);
      ASSERT_TRUE(numbers.has_value()) << kind.name;
      ASSERT_EQ(*numbers, plumb::degenerate::case_of(kind, kind.generators[i / 5].name, 2026, i % 5)) << kind.name;
      ASSERT_EQ(plumb::degenerate::bytes_of(kind, *numbers), seeds[i]);
    }
    // Any bytes are a case or none.
    int made = 0;
    for (std::uint64_t i = 0; i < 200; ++i) {
      plumb::Entropy entropy(64, i);
      std::vector<std::uint8_t> bytes(entropy.below(300));
      for (auto& byte : bytes) byte = static_cast<std::uint8_t>(entropy.bits(8));
      const auto numbers = plumb::degenerate::numbers_from(kind, bytes);
      if (numbers) {
        ASSERT_EQ(plumb::degenerate::flaw_of(kind, *numbers), "");
      }
      made += numbers.has_value();
    }
    EXPECT_GT(made, 60) << kind.name;
  }
}

TEST(FuzzTarget, EndsWhereTheAnswerIsWrong) {
  using namespace plumb::degenerate;
  const Kind& kind = kind_named("orient2d");
  const double x = 0.5 + 0x1p-53 * 2;
  const Numbers right{0, 0, 1, 0, 0, 1}, wrong{x, 0.5, 12, 12, 24, 24};
  ASSERT_EQ(judge(kind, wrong, callable_of(kind, naive_orient2d)(wrong), {}).verdict, Verdict::wrong);
  EXPECT_EQ(fuzz_target(kind, naive_orient2d, bytes_of(kind, right)), 0);
  EXPECT_DEATH(fuzz_target(kind, naive_orient2d, bytes_of(kind, wrong)), "orient2d answered 0, exactly it is");
  EXPECT_THROW(fuzz_target(kind_named("orient3d"), naive_orient2d, bytes_of(kind, wrong)), plumb::Error);
}

TEST(FuzzTarget, DictionaryHoldsEachDoubleOnce) {
  std::istringstream lines(plumb::degenerate::fuzz_dictionary());
  std::set<std::string> bytes;
  int entries = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.front() == '#') continue;
    ++entries;
    const std::size_t start = line.find('"');
    ASSERT_EQ(line.size(), start + 2 + 8 * 4) << line;
    bytes.insert(line.substr(start));
  }
  EXPECT_EQ(bytes.size(), static_cast<std::size_t>(entries));
  EXPECT_GT(entries, 15);
  EXPECT_TRUE(bytes.count("\"\\x00\\x00\\x00\\x00\\x00\\x00\\xF0\\x3F\""));
}

}  // namespace
