#include "plumb/arith/occurrence.hpp"

#include <gtest/gtest.h>

#include "plumb/certify/formula.hpp"
#include "plumb/predicates/manifest.hpp"

namespace plumb {
namespace {

template <Formula F>
constexpr auto of = evaluate<F>([](std::size_t i) { return Occurrence<arity<F>>::coordinate(i); });

constexpr std::uint64_t bits(std::initializer_list<int> which) {
  std::uint64_t mask = 0;
  for (const int i : which) mask |= std::uint64_t{1} << i;
  return mask;
}

TEST(OccurrenceTest, DeterminantsAreLinearInEachCoordinate) {
  for (const std::uint8_t degree : of<predicates::Orient2d>.degree) EXPECT_EQ(degree, 1);
  for (const std::uint8_t degree : of<predicates::Orient3d>.degree) EXPECT_EQ(degree, 1);
}

TEST(OccurrenceTest, KnowsWhatIsMultiplied) {
  EXPECT_EQ(of<predicates::Orient2d>.beside[0], bits({3, 5}));
  EXPECT_EQ(of<predicates::Orient2d>.beside[4], bits({1, 3, 5}));  // the terms in x and y of the last point cancel
  EXPECT_EQ(of<predicates::Orient3d>.beside[0], bits({4, 5, 7, 8, 10, 11}));
}

TEST(OccurrenceTest, CirclesHaveSquaresButNoProductsWithinAPoint) {
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(of<predicates::InCircle>.degree[i], 2);
    EXPECT_EQ(of<predicates::InCircle>.beside[i] & bits({static_cast<int>(i ^ 1)}), 0u);
  }
  EXPECT_EQ(of<predicates::InCircle>.degree[6], 3);  // an upper bound: the third powers cancel
}

TEST(OccurrenceTest, CountsNoFurtherThan255) {
  auto x = Occurrence<2>::coordinate(1);
  for (int i = 0; i < 9; ++i) x = x * x;
  EXPECT_EQ(x.degree[1], 255);
  EXPECT_EQ(x.degree[0], 0);
  EXPECT_EQ(x.beside[1], 0u);
}

}  // namespace
}  // namespace plumb
