// What does a decision cost those who compile without NDEBUG, or without optimization?  Instructions, counted one by
// one, since times differ from run to run.
#include <gtest/gtest.h>
#include <sys/ptrace.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <string>
#include <vector>

namespace {

/// Instructions of a program between its signals, in turn: between the first and the second, the third and the fourth.
/// Nothing where it may not be traced.
std::vector<long> counts(const std::string& program) {
  const pid_t child = ::fork();
  if (child == 0) {
    if (::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0) ::_exit(1);
    ::execl(program.c_str(), program.c_str(), nullptr);
    ::_exit(1);
  }
  std::vector<long> all;
  bool counting = false;
  for (int status = 0; ::waitpid(child, &status, 0) == child && WIFSTOPPED(status);) {
    if (WSTOPSIG(status) == SIGUSR1) {
      counting = !counting;
      if (counting) all.push_back(0);
    } else if (counting) {
      ++all.back();
    }
    ::ptrace(counting ? PTRACE_SINGLESTEP : PTRACE_CONT, child, nullptr, nullptr);
  }
  if (all.empty()) return {};
  for (std::size_t i = 1; i < all.size(); ++i) all[i] -= all[0];  // what raising a signal takes
  all.erase(all.begin());
  return all;
}

const char* const questions[]{"orient2d",
                              "orient3d",
                              "incircle",
                              "insphere",
                              "orient2d, collinear",
                              "orient3d, coplanar",
                              "incircle, collinear",
                              "insphere, coplanar"};

// One program by the flags that it was compiled with.
struct Programs {
  const char *not_optimized, *optimized, *without_assertions;
};

class PlainFlags : public testing::Test {
 protected:
  void SetUp() override {
    fast_ = counts(programs_.without_assertions);
    ASSERT_FALSE(fast_.empty())
        << "a program may not be traced here: allow ptrace (of a container, --cap-add=SYS_PTRACE)"
           ", or leave this test out by ctest -E certify/plain_flags";
    ASSERT_EQ(fast_.size(), std::size(questions));
  }

  const Programs programs_{PLUMB_PROGRAMS};
  std::vector<long> fast_;
};

TEST_F(PlainFlags, CostNothingWithoutNdebug) { EXPECT_EQ(counts(programs_.optimized), fast_); }

TEST_F(PlainFlags, CostAtMostTenTimesWithoutOptimization) {
  const std::vector<long> plain = counts(programs_.not_optimized);
  ASSERT_EQ(plain.size(), fast_.size());
  for (std::size_t i = 0; i < plain.size(); ++i) {
    EXPECT_GT(fast_[i], 10) << questions[i];
    EXPECT_LE(plain[i], 10 * fast_[i]) << questions[i];
  }
}

}  // namespace
