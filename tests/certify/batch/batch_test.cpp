// Do batches tell the signs that the predicates tell one by one?  Laws 1 and 4 of certify/batch.hpp.
#include <cstdlib>

#include "certify/batch/batch_cases.hpp"

namespace plumb::batches {
namespace {

const std::size_t longest = battery::sanitized ? 20 : 70;
constexpr Sign untouched{7};

TYPED_TEST(EveryFormula, TellsTheSignOfEachCaseAtEveryLength) {
  using F = TypeParam;
  for (const FamilyInfo& f : families) {
    SCOPED_TRACE(f.name);
    const std::vector<Coordinates<F>> cases = cases_of<F>(f.family, longest + 7);
    const std::vector<Sign> truth = signs_of<F>(cases);
    const Arrays<F> arrays(cases);
    on_each_instruction_set([&] {
      for (std::size_t n = 0; n <= longest; ++n) {
        const std::size_t first = n * 3 % 8;  // arrays begin anywhere between two vectors
        for (const auto ask : {ask_points<F>, ask_views<F>}) {
          std::vector<Sign> out(n + 2, untouched);
          ask(arrays, first, n, std::span(out).first(n), Execution::serial);
          ASSERT_EQ(difference<F>(cases, truth, first, std::span(out).first(n)), "") << n << " cases";
          ASSERT_EQ(out[n], untouched);
          ASSERT_EQ(out[n + 1], untouched);
        }
      }
    });
  }
}

TYPED_TEST(EveryFormula, TellsTheSameSignsOnManyThreads) {
  using F = TypeParam;
#if defined(PLUMB_LONG_TESTS)
  constexpr std::size_t count = 3'000'000;
#else
  const std::size_t count = battery::fitting<std::uint64_t>(30'000);
#endif
  for (const Family family : {Family::uniform, Family::off_by_ulps, Family::mixture}) {
    const std::vector<Coordinates<F>> cases = cases_of<F>(family, count);
    const std::vector<Sign> truth = signs_of<F>(cases);
    const Arrays<F> arrays(cases);
    for (const Execution execution : {Execution::serial, Execution::parallel}) {
      for (const auto ask : {ask_points<F>, ask_views<F>}) {
        std::vector<Sign> out(count, untouched);
        ask(arrays, 0, count, out, execution);
        ASSERT_EQ(difference<F>(cases, truth, 0, out), "");
      }
    }
  }
}

// Representative: the vectors themselves must decide, and be unsure, and in the same batch.
TYPED_TEST(EveryFormula, MeetsAllSignsInTheMixture) {
  using F = TypeParam;
  std::array<int, 3> count{};
  for (const Sign s : signs_of<F>(cases_of<F>(Family::mixture, 1000)))
    ++count[static_cast<std::size_t>(static_cast<int>(s) + 1)];
  for (const int c : count) EXPECT_GT(c, 50);
}

TEST(Batches, TakeWhatConvertsToSpans) {
  const std::vector<Point2> a{{0, 0}, {0, 0}}, b{{1, 0}, {1, 0}};
  const std::array<Point2, 2> c{Point2{0, 1}, Point2{2, 0}};
  std::array<Sign, 2> out{};
  orient2d(a, b, c, out);
  EXPECT_EQ(out[0], Sign::positive);
  EXPECT_EQ(out[1], Sign::zero);
  const std::array<double, 2> zeros{0, 0}, ones{1, 1}, x{0, 2}, y{-1, 0};
  orient2d(Points2View{zeros, zeros}, Points2View{ones, zeros}, Points2View{x, y}, out, Execution::parallel);
  EXPECT_EQ(out[0], Sign::negative);
  EXPECT_EQ(out[1], Sign::zero);
}

TEST(Batches, TakeOneArrayForSeveralArguments) {
  const std::vector<Point3> p{{1, 2, 3}, {4, 5, 7}, {0, 0, 1}};
  std::vector<Sign> out(3, untouched);
  orient3d(p, p, p, p, out);
  EXPECT_EQ(out, std::vector<Sign>(3, Sign::zero));
}

TEST(Batches, TellWhichInstructionSetsThereAre) {
  const std::vector<std::string_view> sets = batch_instruction_sets();
  for (const std::string_view set : sets) std::cout << set << " was tested\n";
  ASSERT_FALSE(sets.empty());
  EXPECT_EQ(sets.back(), "none");
  const char* forced = std::getenv("PLUMB_INSTRUCTION_SET");
  EXPECT_EQ(batch_instruction_set(), forced != nullptr ? forced : sets.front());
}

void ask_and_exit() {
  const std::vector<Point2> a{{0, 0}}, b{{1, 0}}, c{{0, 1}};
  std::vector<Sign> out(1, untouched);
  try {
    orient2d(a, b, c, out);
    std::cerr << batch_instruction_set() << " says " << to_char(out[0]) << "\n";
  } catch (const Error& e) {
    std::cerr << e.what() << "\n";
  }
  std::_Exit(0);
}

/// Each in a process of its own, which reads the environment anew.
TEST(BatchesDeathTest, TakeTheInstructionSetOfTheEnvironment) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  for (const std::string_view set : batch_instruction_sets()) {
    setenv("PLUMB_INSTRUCTION_SET", std::string(set).c_str(), 1);
    EXPECT_EXIT(ask_and_exit(), testing::ExitedWithCode(0), std::string(set) + " says \\+");
  }
  setenv("PLUMB_INSTRUCTION_SET", "avx9", 1);
  EXPECT_EXIT(ask_and_exit(), testing::ExitedWithCode(0),
              "PLUMB_INSTRUCTION_SET is \"avx9\", which this processor does not have; there are .*none");
  unsetenv("PLUMB_INSTRUCTION_SET");
}

}  // namespace
}  // namespace plumb::batches
