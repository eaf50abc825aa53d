// Are coordinates that were brought to one size the same coordinates, for the formula?
#include <gtest/gtest.h>

#include <cmath>

#include "certify/battery.hpp"
#include "plumb/certify/decide.hpp"

namespace plumb::battery {
namespace {

template <class F>
struct LevelsTest : testing::Test {};
using Classics = testing::Types<predicates::Orient2d, predicates::Orient3d, predicates::InCircle, predicates::InSphere>;
TYPED_TEST_SUITE(LevelsTest, Classics);

// The field of the exponent, by which subnormal numbers are all alike.
int field(double x) { return std::max(std::ilogb(x), -1023) + 1023; }

template <Formula F>
void expect_the_spans(const Coordinates<F>& p, const certify::Levels<F>& levels) {
  constexpr std::size_t count = certify::Levels<F>::count;
  int most = 0, highest = -4096, lowest = 4096;
  for (std::size_t axis = 0; axis < count; ++axis) {
    int high = -4096, low = 4096;
    for (std::size_t i = axis; i < p.size(); i += count) {
      if (p[i] == 0) continue;
      high = std::max(high, field(p[i]));
      low = std::min(low, field(p[i]));
    }
    if (low <= high) most = std::max(most, high - low);
    highest = std::max(highest, high);
    lowest = std::min(lowest, low);
  }
  EXPECT_EQ(levels.span(), most);
  if (lowest > highest) return;
  EXPECT_EQ(levels.span_of_all(), highest - lowest);
  EXPECT_EQ(levels.are_low(), highest < 64);
}

TYPED_TEST(LevelsTest, TheAxesOfDeterminantsHaveLevelsOfTheirOwn) {
  EXPECT_EQ(certify::level_count<TypeParam>, degree<TypeParam>() < 4 ? std::size_t(TypeParam::dimension) : 1U);
}

// Law: times one power of two for each level, exactly; so the sign is the same.
TYPED_TEST(LevelsTest, AreTheCoordinatesTimesPowersOfTwo) {
  constexpr std::size_t count = certify::Levels<TypeParam>::count;
  const CatalogEntry& e = *find_predicate(TypeParam::name);
  int exact = 0, low = 0;
  for (const Family family : {Family::extreme, Family::mixture, Family::wide, Family::repeated}) {
    for (std::uint64_t n = 0; n < 1'000; ++n) {
      Coordinates<TypeParam> p{};
      std::ranges::copy(coordinates_of(e, family, n), p.begin());
      const certify::Levels<TypeParam> levels(p);
      expect_the_spans<TypeParam>(p, levels);
      if (levels.are_low()) {
        ++low;
        const Coordinates<TypeParam> raised = certify::raised<TypeParam>(p);
        for (std::size_t i = 0; i < p.size(); ++i) EXPECT_EQ(std::ldexp(raised[i], -1000), p[i]);
      }
      if (levels.span() > 900) continue;
      ++exact;
      const Coordinates<TypeParam> leveled = levels.at(p);
      for (std::size_t axis = 0; axis < count; ++axis) {
        int power = 9999;
        double largest = 0;
        for (std::size_t i = axis; i < p.size(); i += count) {
          largest = std::max(largest, std::fabs(leveled[i]));
          if (p[i] == 0) {
            EXPECT_EQ(leveled[i], 0);
            continue;
          }
          if (power == 9999) power = std::ilogb(leveled[i]) - std::ilogb(p[i]);
          EXPECT_EQ(std::ldexp(leveled[i], -power), p[i]);
          EXPECT_EQ(std::ilogb(leveled[i]) - std::ilogb(p[i]), power);
        }
        EXPECT_TRUE(largest == 0 || (largest >= 0x1p-51 && largest < 4)) << largest;
      }
      EXPECT_EQ(oracle::rational_sign(e.name, leveled), oracle::rational_sign(e.name, p));
    }
  }
  EXPECT_GT(exact, 2'000);
  EXPECT_GT(low, 50);
}

}  // namespace
}  // namespace plumb::battery
