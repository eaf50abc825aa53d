// What the program says and shows: the progress bar, the doctor's report, files that cannot be written.
#include "tool/terminal/terminal.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

#include "plumb/arith/error.hpp"
#include "tool/doctor/command.hpp"
#include "tool/run_program.hpp"
#include "tool/terminal/progress.hpp"

namespace plumb::tool {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

TEST(Progress, CountsOverThreadsDrawsSeldomAndIsGoneInTheEnd) {
  const Folder folder;
  std::FILE* const stream = std::fopen((folder / "bar").c_str(), "w");
  const auto begin = std::chrono::steady_clock::now();
  {
    Progress progress("deciding", 4000, stream, true);
    std::vector<std::thread> workers;
    for (int t = 0; t < 4; ++t) {
      workers.emplace_back([&progress] {
        for (int i = 0; i < 1000; ++i) {
          progress.advance();
          std::this_thread::sleep_for(std::chrono::microseconds(300));
        }
      });
    }
    for (std::thread& w : workers) w.join();
    EXPECT_EQ(progress.done(), 4000U);
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  std::fclose(stream);
  const std::string shown = content(folder / "bar");
  const auto drawings = std::count(shown.begin(), shown.end(), '%');
  EXPECT_GE(drawings, 1);
  EXPECT_LE(static_cast<double>(drawings), seconds * 10 + 1);
  EXPECT_THAT(shown, AllOf(HasSubstr("deciding"), EndsWith("\r\033[K"), Not(HasSubstr("\n"))));
}

TEST(Progress, IsSilentWhereNotShownAndOnShortWork) {
  const Folder folder;
  std::FILE* const stream = std::fopen((folder / "bar").c_str(), "w");
  {
    Progress hidden("deciding", 2, stream, false);
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    hidden.advance(2);
    EXPECT_EQ(hidden.done(), 2U);
    Progress quick("deciding", 2, stream, true);
    quick.advance(2);
  }
  std::fclose(stream);
  EXPECT_EQ(content(folder / "bar"), "");
}

TEST(Progress, SurvivesMoreStepsThanAnnounced) {
  const Folder folder;
  std::FILE* const stream = std::fopen((folder / "bar").c_str(), "w");
  {
    Progress none("nothing", 0, stream, true), more("more", 1, stream, true);
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    none.advance(3);
    more.advance(1000);
  }
  std::fclose(stream);
  EXPECT_THAT(content(folder / "bar"), AllOf(HasSubstr("100 %  nothing"), HasSubstr("100 %  more")));
}

TEST(Doctor, NamesEachBrokenAssumptionAndItsMend) {
  const Environment sound{true, true, false, false, "0.1.0", "GCC", "release", {"sse2", "avx2"}};
  const Style plain(false);
  EXPECT_THAT(doctor_report(sound, plain), AllOf(HasSubstr("sse2 avx2"), Not(HasSubstr("BAD"))));
  const auto report = [&](auto change) {
    Environment e = sound;
    change(e);
    const std::string text = doctor_report(e, plain);
    EXPECT_THAT(text, AllOf(HasSubstr("BAD"), HasSubstr("signs may be wrong")));
    return text;
  };
  EXPECT_THAT(report([](Environment& e) { e.rounds_to_nearest = false; }), HasSubstr("FE_TONEAREST"));
  EXPECT_THAT(report([](Environment& e) { e.keeps_subnormals = false; }), HasSubstr("FTZ"));
  EXPECT_THAT(report([](Environment& e) { e.contracts = true; }), HasSubstr("-ffp-contract=off"));
  EXPECT_THAT(report([](Environment& e) { e.fast_math = true; }), HasSubstr("without -ffast-math"));
}

}  // namespace
}  // namespace plumb::tool
