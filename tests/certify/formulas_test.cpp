// Does every stage of every formula agree with the oracles, whatever the shape of its arguments?  A lighter battery
// than that of the four classics (agreement.hpp), for all formulas beyond them.
#include <gtest/gtest.h>

#include <iostream>

#include "certify/tally.hpp"

namespace plumb::battery {
namespace {

#if defined(PLUMB_LONG_TESTS)
constexpr std::uint64_t cases_each = 50'000;
#else
const std::uint64_t cases_each = fitting<std::uint64_t>(300);
#endif

std::span<const CatalogEntry> formulas() { return catalog().subspan(classics().size()); }

class Formulas : public testing::TestWithParam<std::size_t> {
 protected:
  [[nodiscard]] const CatalogEntry& entry() const { return formulas()[GetParam()]; }

  // Holds every stage against the rationals, and CGAL where it is asked, at case number i of the sort that fill makes.
  template <class Fill>
  Tally try_cases(std::string_view sort, std::uint64_t count, Fill fill) {
    Tally tally;
    std::vector<double> p(entry().arity());
    for (std::uint64_t i = 0; i < count && !HasFatalFailure(); ++i) {
      Entropy entropy(start_of(entry()), i);
      fill(p, entropy);
      [&] {
        ASSERT_EQ(disagreement(entry(), p, {true, i % 9 == 0}), "") << sort << ' ' << i << ": " << report(entry(), p);
      }();
      tally.add(entry().decide(p));
    }
    return tally;
  }
};

TEST_P(Formulas, TellTheTrueSignOnEveryFamily) {
  for (const FamilyInfo& f : families) {
    const Tally tally = try_cases(f.name, cases_each, [&](std::vector<double>& p, Entropy& entropy) {
      fill_arguments(entry(), f.family, p, entropy);
    });
    if (HasFatalFailure()) return;
    std::cout << entry().name << ' ' << f.name << tally << '\n';
    if (f.family == Family::uniform) {
      EXPECT_GE(tally.decided(Stage::filter), 0.98);
    }
  }
}

// The families above need not hit a formula's zeros; these do.
TEST_P(Formulas, TellTheTrueSignAtTheirZeros) {
  const auto tiny = [](std::vector<double>& p, Entropy& entropy) {
    fill_tiny(1 + static_cast<std::int64_t>(entropy.below(3)), p, entropy);
  };
  const auto zero = [&](std::vector<double>& p, Entropy& entropy) { fill_at_zero(entry(), p, entropy); };
  const auto near = [&](std::vector<double>& p, Entropy& entropy) { fill_near_zero(entry(), p, entropy); };
  const Tally small = try_cases("tiny", 10 * cases_each, tiny);
  const Tally at_zero = try_cases("at zero", 3 * cases_each, zero);
  const Tally near_zero = try_cases("near zero", 10 * cases_each, near);
  if (HasFatalFailure()) return;
  std::cout << entry().name << ":\n  tiny" << small << "\n  zero" << at_zero << "\n  near" << near_zero << '\n';
  for (const Sign s : {Sign::negative, Sign::zero, Sign::positive}) EXPECT_GE(small.share(s), 0.01) << to_char(s);
  const double least = cases_each < 100 ? 0 : 0.003;  // sanitized runs take too few cases to tell
  for (const Sign s : {Sign::negative, Sign::zero, Sign::positive}) EXPECT_GE(near_zero.share(s), least) << to_char(s);
  EXPECT_GE(at_zero.share(Sign::zero), 0.5);
  if (entry().degree > 1) {
    EXPECT_LE(near_zero.decided(Stage::filter), 0.8);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Formulas, testing::Range<std::size_t>(0, formulas().size()),
                         [](const auto& at) { return std::string(formulas()[at.param].name); });

}  // namespace
}  // namespace plumb::battery
