// The statement of crossings: which bounds were derived, and does each world tell what is so?
#include "space/octree/crossing_sign.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "certify/statements/golden_statements.hpp"
#include "certify/statements/mutant_statements.hpp"
#include "certify/statements/promised_share.hpp"
#include "certify/statements/proved_statements.hpp"
#include "plumb/certify/judged_proofs.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/degenerate/points.hpp"

namespace plumb::space {
namespace {

template <class Statement, class... Input>
void expect_bounds_of(const char* name, const Statement& statement, const Input&... input) {
  const std::vector<std::string> bounds = judged_bounds(statement, input...);
  expect_golden(name, bounds);
  expect_proved(bounds, judged_proofs(name, statement, input...));
}

TEST(CrossingSign, DerivedBoundsAreAsRecordedAndProved) {
  expect_bounds_of("crossing_of_ray", CrossingOrder<false>{}, 1.0, 0.25, 3.0, 2.0, 0.5, -1.0);
  expect_bounds_of("crossing_of_segment", CrossingOrder<true>{}, 1.0, 0.25, 3.0, 2.0, 0.5, -1.0);
}

/// By fractions; `from` is what a segment's ends are seen from.
int truth(bool is_segment, const std::array<double, 6>& x) {
  const mpq_class c(x[0]), o(x[1]), f(x[2]), d(x[3]), p(x[4]), e(x[5]), zero(0);
  const mpq_class way_f = f - (is_segment ? o : zero), way_e = e - (is_segment ? p : zero);
  return sgn(mpq_class((c - o) * way_e - (d - p) * way_f));
}

TEST(CrossingSign, IsThatOfTheExactProducts) {
  int zeros = 0, doubtful = 0;
  for (const FamilyInfo& info : families) {
    for (std::uint64_t i = 0; i < 500; ++i) {
      Entropy e(7414, i);
      std::array<double, 6> x{};
      fill_points(info.family, Degeneracy::collinear, 2, x, e);
      if (i % 3 == 0) x[5] = x[2], x[4] = x[1], x[3] = x[0];  // both at once
      const auto ask = [&](const auto& statement, bool is_segment) {
        const Sign told = certainly(statement, x[0], x[1], x[2], x[3], x[4], x[5]);
        ASSERT_EQ(static_cast<int>(told), truth(is_segment, x)) << info.name << ", replay: " << i;
        ASSERT_EQ(crossing_order(is_segment, x[0], x[1], x[2], x[3], x[4], x[5]), told)
            << info.name << ", replay: " << i;
        zeros += told == Sign::zero ? 1 : 0;
        FloatWorld<std::remove_cvref_t<decltype(statement)>> w;
        const Sign by_doubles = statement(w, x[0], x[1], x[2], x[3], x[4], x[5]);
        ASSERT_EQ(w.certain() ? by_doubles : told, told) << info.name << ", replay: " << i;
        doubtful += w.certain() ? 0 : 1;
      };
      ask(CrossingOrder<false>{}, false);
      ask(CrossingOrder<true>{}, true);
    }
  }
  EXPECT_GE(zeros, 1000);
  EXPECT_GE(doubtful, 500);
}

/// Which world tells it where exponents span all that there are: integers a tenth at most, and never rationals.
TEST(CrossingSign, IsToldByItsOwnErrorsWhereExponentsAreFarApart) {
  WorldCounts worlds;
  int doubtful = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    Entropy entropy(7415, i);
    const auto number = [&] {
      return std::ldexp(signed_unit_coordinate(entropy), static_cast<int>(entropy.below(801)) - 400);
    };
    const std::array x{number(), number(), number(), number(), number(), number()};
    FloatWorld<CrossingOrder<true>> first;
    (void)CrossingOrder<true>{}(first, x[0], x[1], x[2], x[3], x[4], x[5]);
    doubtful += first.certain() ? 0 : 1;
    const Sign told = certainly_recorded<SpreadWorlds<CrossingOrder<true>>>(worlds, CrossingOrder<true>{}, x[0], x[1],
                                                                            x[2], x[3], x[4], x[5]);
    ASSERT_EQ(static_cast<int>(told), truth(true, x)) << "replay: " << i;
  }
  EXPECT_GE(doubtful, 200);
  EXPECT_LE(worlds.of(WorldKind::integers), 200u);
  EXPECT_EQ(worlds.of(WorldKind::rationals), 0u);
}

TEST(CrossingSign, DoublesTellItInPromisedShare) {
  const auto draw = [](const auto& ask, const std::array<double, 6>& x) { ask(x[0], x[1], x[2], x[3], x[4], x[5]); };
  expect_share<6>("crossing_of_ray", CrossingOrder<false>{}, draw, 2);
  expect_share<6>("crossing_of_segment", CrossingOrder<true>{}, draw, 2);
}

template <bool is_segment>
std::string unnoticed() {
  using Numbers = std::array<double, 6>;
  return mutants::unnoticed(
      [](mutants::Draw& d) { return Numbers{d.number(), d.number(), d.number(), d.number(), d.number(), d.number()}; },
      [](const Numbers& x) {
        return mutants::told<mutants::World>(CrossingOrder<is_segment>{}, x[0], x[1], x[2], x[3], x[4], x[5]);
      },
      [](const Numbers& x) { return static_cast<Sign>(truth(is_segment, x)); }, 0, 2000);
}
TEST(CrossingSign, MutantsAreNoticed) {
  mutants::expect_noticed("crossing_of_ray", unnoticed<false>());
  mutants::expect_noticed("crossing_of_segment", unnoticed<true>());
}

}  // namespace
}  // namespace plumb::space
