// Section 1.9 of the contract: where PLUMB_CHECKED is defined, nothing is decided where the proofs do not hold.
#ifndef PLUMB_CHECKED
#define PLUMB_CHECKED
#endif

#include <gtest/gtest.h>

#include <cfenv>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "plumb/certify/bounded_points.hpp"
#include "plumb/figure.hpp"
#include "plumb/predicates.hpp"

namespace plumb {

/// In unchecked_decisions.cpp: how many of the decisions below are as expected there.
int decide_unchecked();

namespace {

/// In one rounding mode after another, what may be asked of a thread.
template <class Decide>
void expect_refused(Decide decide) {
  decide();
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    EXPECT_DEATH((std::fesetround(mode), decide()), "does not round to nearest") << mode;
  }
#if defined(__SSE2__)
  for (const unsigned mode : {0x8000U, 0x0040U}) {
    EXPECT_DEATH((_mm_setcsr(_mm_getcsr() | mode), decide()), "flushes subnormals") << mode;
  }
#endif
}

using predicates::Orient2d;
const Point2 a{0, 0}, b{1, 0}, c{0, 1};

TEST(CheckedDeathTest, RefusesPlainFunctions) {
  expect_refused([] { EXPECT_EQ(orient2d(a, b, c), Sign::positive); });
}

TEST(CheckedDeathTest, RefusesSignOf) {
  expect_refused([] { EXPECT_EQ(sign_of(Orient2d{}, a, b, c), Sign::positive); });
}

TEST(CheckedDeathTest, RefusesDecide) {
  expect_refused([] { EXPECT_EQ(decide<Orient2d>({0, 0, 1, 0, 0, 1}), Sign::positive); });
}

TEST(CheckedDeathTest, RefusesSides) {
  expect_refused([] { EXPECT_EQ(LineSide(a, b)(c), Sign::positive); });
}

TEST(CheckedDeathTest, RefusesBoundedPoints) {
  expect_refused([] {
    const BoundedPoints<Point2> scene(std::array{a, b, c});
    EXPECT_EQ(scene.predicate<Orient2d>()(0, 1, 2), Sign::positive);
  });
}

TEST(CheckedDeathTest, RefusesImplicitPoints) {
  expect_refused([] { EXPECT_EQ(orient2d(a, b, LineLinePoint2{a, c, c, {1, 1}}), Sign::positive); });
}

TEST(CheckedDeathTest, RefusesSpheres) {
  expect_refused([] { EXPECT_TRUE(intersects(Sphere3{{0, 0, 0}, 1}, Sphere3{{1, 0, 0}, 1})); });
}

// Linked together, no function that looks stands in for one that does not, nor the other way around: without
// optimization nothing is inlined, and the linker meets each function twice.
TEST(CheckedDeathTest, LeavesOtherFilesAlone) {
  const int before = std::fegetround();
  std::fesetround(FE_UPWARD);
  const int decided = decide_unchecked();
  std::fesetround(before);
  EXPECT_EQ(decided, 5);
}

constexpr bool decided_by_compiler() { return decide<Orient2d>({0, 0, 1, 0, 0, 1}) == Sign::positive; }
static_assert(decided_by_compiler());

}  // namespace
}  // namespace plumb
