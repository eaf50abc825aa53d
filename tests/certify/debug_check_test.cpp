// Section 1.9 of the contract: debug builds refuse to decide where the proofs do not hold.
#undef NDEBUG  // this file is a debug build, whatever the rest is

#include <gtest/gtest.h>

#include <cfenv>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "plumb/predicates.hpp"

namespace plumb {
namespace {

Sign decided() { return orient2d({0, 0}, {1, 0}, {0, 1}); }

TEST(DebugCheckDeathTest, RefusesOtherRoundingModes) {
  EXPECT_EQ(decided(), Sign::positive);
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    EXPECT_DEATH(std::fesetround(mode) == 0 ? decided() : Sign::zero, "does not round to nearest") << mode;
  }
}

#if defined(__SSE2__)
TEST(DebugCheckDeathTest, RefusesFlushedSubnormals) {
  for (const unsigned mode : {0x8000U, 0x0040U}) {
    EXPECT_DEATH((_mm_setcsr(_mm_getcsr() | mode), decided()), "flushes subnormals") << mode;
  }
}
#endif

}  // namespace
}  // namespace plumb
