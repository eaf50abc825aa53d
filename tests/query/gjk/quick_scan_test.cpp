// Scans by lanes of two and of four: both name the first of the farthest points, of every number of them.
#include "query/gjk/quick_scan.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "certify/fused.hpp"
#include "plumb/degenerate/coordinates.hpp"

namespace plumb::query {
namespace {

/// One after the other, the products added as the lanes add them: of even places x, y, z, of odd ones y, z, x.
std::uint32_t first_farthest(const std::vector<Point3>& all, const Vector3& n) {
  const auto reach = [&](std::size_t i) {
    const Point3& p = all[i];
    return i % 2 == 0 ? (p.x * n.x + p.y * n.y) + p.z * n.z : (p.y * n.y + p.z * n.z) + p.x * n.x;
  };
  std::size_t best = 0;
  for (std::size_t i = 1; i < all.size(); ++i) {
    if (reach(i) > reach(best)) best = i;
  }
  return static_cast<std::uint32_t>(best);
}

TEST(QuickScan, LanesNameTheFirstOfTheFarthest) {
  Entropy entropy(38, 1);
  int ties = 0;
  for (std::size_t size = 4; size <= 140; ++size) {
    for (int turn = 0; turn < 6; ++turn) {
      const bool is_grid = turn % 2 == 0;  // of few different numbers, so that many are as far
      const auto number = [&] {
        const double x = signed_unit_coordinate(entropy);
        return is_grid ? std::round(2 * x) : x;
      };
      const Vector3 n{number(), number(), number()};
      std::vector<Point3> all;
      for (std::size_t i = 0; i < size; ++i) all.push_back({number(), number(), number()});
      const std::uint32_t best = first_farthest(all, n);
      // The last block begins within the one before it, at an odd place of it: what is rounded otherwise is no tie.
      if (size % 2 == 0 || is_grid) {
        EXPECT_EQ(quick_scan::farthest_by_pairs(all.data(), static_cast<std::uint32_t>(size), n.x, n.y, n.z), best);
        if (has_fma) {
          EXPECT_EQ(quick_scan::farthest_by_fours(all.data(), static_cast<std::uint32_t>(size), n.x, n.y, n.z), best);
        }
      }
      std::vector<Point3> turned(all.rbegin(), all.rend());
      ties += size - 1 - first_farthest(turned, n) != best ? 1 : 0;
    }
  }
  EXPECT_GT(ties, 200);
}

TEST(QuickScan, LanesAgreeOfNumbersThatAreNone) {
  if (!has_fma) return;
  for (const std::uint32_t size : {4U, 7U, 8U, 20U, 64U, 65U, 130U}) {
    std::vector<Point3> all(size, Point3{1, 2, 3});
    all[size / 2].y = NAN, all[size - 1].x = HUGE_VAL;
    EXPECT_LT(quick_scan::farthest_by_pairs(all.data(), size, 1, 1, 1), size);
    EXPECT_LT(quick_scan::farthest_by_fours(all.data(), size, 1, 1, 1), size);
  }
}

}  // namespace
}  // namespace plumb::query
