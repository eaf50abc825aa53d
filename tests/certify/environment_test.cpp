#include "plumb/certify/environment.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <thread>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace plumb {
namespace {

TEST(EnvironmentTest, IsSoundHere) {
  const Environment e = check_environment();
  EXPECT_TRUE(e.rounds_to_nearest);
  EXPECT_TRUE(e.keeps_subnormals);
  EXPECT_FALSE(e.contracts);
  EXPECT_FALSE(e.fast_math);
  EXPECT_TRUE(e.sound());
  EXPECT_FALSE(e.version.empty());
  EXPECT_FALSE(e.compiler.empty());
  EXPECT_FALSE(e.build.empty());
}

TEST(EnvironmentTest, ReportsEveryOtherRoundingModeOfItsThreadAlone) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::thread([mode] {
      ASSERT_EQ(std::fesetround(mode), 0);
      const Environment e = check_environment();
      EXPECT_EQ(std::fegetround(), mode);  // checks, never changes
      std::fesetround(FE_TONEAREST);
      EXPECT_FALSE(e.rounds_to_nearest) << mode;
      EXPECT_FALSE(e.sound());
      EXPECT_TRUE(check_environment().sound());
    }).join();
  }
  EXPECT_TRUE(check_environment().sound());
}

#if defined(__SSE2__)
TEST(EnvironmentTest, ReportsFlushedResultsAndFlushedOperands) {
  constexpr unsigned flush_to_zero = 0x8000, denormals_are_zero = 0x0040;
  for (const unsigned mode : {flush_to_zero, denormals_are_zero, flush_to_zero | denormals_are_zero}) {
    std::thread([mode] {
      const unsigned before = _mm_getcsr();
      _mm_setcsr(before | mode);
      const Environment e = check_environment();
      const unsigned after = _mm_getcsr();
      _mm_setcsr(before);
      EXPECT_EQ(after & mode, mode);
      EXPECT_FALSE(e.keeps_subnormals) << mode;
      EXPECT_FALSE(e.sound());
      EXPECT_TRUE(check_environment().sound());
    }).join();
  }
  EXPECT_TRUE(check_environment().sound());
}
#endif

TEST(EnvironmentTest, EachFaultAloneIsUnsound) {
  const Environment good = certify::environment::inspect(false, false);
  EXPECT_TRUE(good.sound());
  EXPECT_FALSE(certify::environment::inspect(true, false).sound());
  EXPECT_FALSE(certify::environment::inspect(false, true).sound());
}

}  // namespace
}  // namespace plumb
