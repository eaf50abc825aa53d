// Laws 1 and 2 of degenerate/rapidcheck.hpp, in RapidCheck's own hands.
#include "plumb/degenerate/rapidcheck.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>

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

}  // namespace
