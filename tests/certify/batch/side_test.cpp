// Does one line, plane, circle or sphere tell of every point what the predicate tells?  The laws of certify/side.hpp.
#include <cmath>

#include "certify/batch/batch_cases.hpp"
#include "certify/gappa.hpp"
#include "certify/sanitized.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/certify/proof_script.hpp"

namespace plumb::batches {
namespace {

template <class F>
Side<F> side_of(const Coordinates<F>& c) {
  return [&]<std::size_t... P>(std::index_sequence<P...>) {
    return Side<F>(Arrays<F>::point_of(&c[P * certify::side::dimension<F>])...);
  }
  (std::make_index_sequence<certify::side::points<F> - 1>());
}

/// Cases that share all but the last point, of one set of points.
template <class F>
std::vector<Coordinates<F>> one_against(Family family, std::uint64_t index, std::size_t count) {
  constexpr std::size_t dimension = certify::side::dimension<F>, given = arity<F> - dimension;
  std::vector<double> all(given + count * dimension);
  Entropy entropy(static_cast<std::uint64_t>(99 + F::points), index);
  fill_points(family, zero_set<F>(), F::dimension, all, entropy);
  std::vector<Coordinates<F>> cases(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::copy_n(all.begin(), given, cases[i].begin());
    std::copy_n(&all[given + i * dimension], dimension, cases[i].begin() + given);
  }
  return cases;
}

TYPED_TEST(EveryFormula, TellsTheSignOfEachPoint) {
  using F = TypeParam;
#if defined(PLUMB_LONG_TESTS)
  constexpr std::uint64_t sets = 20'000;
#else
  const std::uint64_t sets = battery::fitting<std::uint64_t>(200);
#endif
  for (const FamilyInfo& f : families) {
    SCOPED_TRACE(f.name);
    for (std::uint64_t index = 0; index < sets; ++index) {
      const std::vector<Coordinates<F>> cases = one_against<F>(f.family, index, 20);
      const std::vector<Sign> truth = signs_of<F>(cases);
      const Side<F> side = side_of<F>(cases[0]);
      std::vector<Sign> out;
      for (const Coordinates<F>& c : cases)
        out.push_back(side(Arrays<F>::point_of(&c[arity<F> - certify::side::dimension<F>])));
      ASSERT_EQ(difference<F>(cases, truth, 0, out), "");
    }
  }
}

TYPED_TEST(EveryFormula, TellsTheSignsOfManyPointsAtEveryLength) {
  using F = TypeParam;
  const std::size_t longest = battery::sanitized ? 20 : 70;
  for (const FamilyInfo& f : families) {
    SCOPED_TRACE(f.name);
    const std::vector<Coordinates<F>> cases = one_against<F>(f.family, 1, longest + 7);
    const std::vector<Sign> truth = signs_of<F>(cases);
    const Arrays<F> arrays(cases);
    const Side<F> side = side_of<F>(cases[0]);
    constexpr std::size_t last = certify::side::points<F> - 1;
    on_each_instruction_set([&] {
      for (std::size_t n = 0; n <= longest; ++n) {
        const std::size_t first = n * 3 % 8;
        std::vector<Sign> out(n, Sign{7}), of_view(n, Sign{7});
        side(arrays.points_at(last, first, n), out);
        ASSERT_EQ(difference<F>(cases, truth, first, out), "") << n << " points";
        side(arrays.view_at(last, first, n), of_view);
        ASSERT_EQ(difference<F>(cases, truth, first, of_view), "") << n << " points of a view";
      }
    });
  }
}

TYPED_TEST(EveryFormula, TellsTheSameSidesOnManyThreads) {
  using F = TypeParam;
  const std::vector<Coordinates<F>> cases =
      one_against<F>(Family::off_by_ulps, 5, battery::fitting<std::uint64_t>(30'000));
  const std::vector<Sign> truth = signs_of<F>(cases);
  const Arrays<F> arrays(cases);
  const Side<F> side = side_of<F>(cases[0]);
  std::vector<Sign> out(cases.size());
  side(arrays.points_at(certify::side::points<F> - 1, 0, cases.size()), out, Execution::parallel);
  EXPECT_EQ(difference<F>(cases, truth, 0, out), "");
}

// The form is the formula: both as rationals, which round nothing.
TYPED_TEST(EveryFormula, IsTheSameNumberInItsForm) {
  using F = TypeParam;
  constexpr const certify::side::Form& form = certify::side::form_of<F>;
  for (std::uint64_t index = 0; index < 50; ++index) {
    const Coordinates<F> p = one_against<F>(Family::mixture, index, 1)[0];
    const auto run = [](const auto& tape, auto number) {
      for (std::size_t i = 0; i < tape.size; ++i) {
        const certify::tape::Instruction in = tape.instructions[i];
        const auto l = number[in.left], r = number[in.right];
        number.push_back(in.operation == '*' ? l * r : in.operation == '-' ? l - r : l + r);
      }
      return number;
    };
    using Rational = decltype(big_rational(0.0));
    std::vector<Rational> given, query;
    for (const double x : p) given.push_back(big_rational(x));
    for (std::size_t a = 0; a < certify::side::dimension<F>; ++a) {
      query.push_back(given[arity<F> - certify::side::dimension<F> + a] -
                      given[certify::side::pivot<F> * certify::side::dimension<F> + a]);
    }
    const auto fixed = run(form.fixed, given), asked = run(form.query, query);
    auto sum = big_rational(0);
    for (std::size_t v = 0; v < form.variables; ++v) {
      const auto term = asked[form.variable[v]] * fixed[form.coefficient[v].number];
      sum = form.coefficient[v].negative ? sum - term : sum + term;
    }
    const auto value = evaluate<F>([&](std::size_t i) { return big_rational(p[i]); });
    EXPECT_EQ((sum - value).sign(), Sign::zero);
  }
}

// Recorded here, derived when compiled; in units of 2^-53, each a little above a whole number.
TEST(Sides, HaveFiltersOfTheirOwn) {
  EXPECT_EQ(std::floor(certify::side::constant<predicates::Orient2d> * 0x1p53), 3);
  EXPECT_EQ(std::floor(certify::side::constant<predicates::Orient3d> * 0x1p53), 7);
  EXPECT_EQ(std::floor(certify::side::constant<predicates::InCircle> * 0x1p53), 10);
  EXPECT_EQ(std::floor(certify::side::constant<predicates::InSphere> * 0x1p53), 16);
  EXPECT_EQ(LineSide::variables, 2u);
  EXPECT_EQ(PlaneSide::variables, 3u);
  EXPECT_EQ(CircleSide::variables, 3u);
  EXPECT_EQ(SphereSide::variables, 4u);
}

/// What a side does to given points and a query, as one program; its sign is turned over where the first term is negative.
template <class F>
std::vector<certify::tape::Instruction> form_instructions() {
  using certify::tape::Instruction;
  constexpr const certify::side::Form& form = certify::side::form_of<F>;
  constexpr std::size_t dimension = certify::side::dimension<F>;
  std::vector<Instruction> all(form.fixed.instructions.begin(),
                               form.fixed.instructions.begin() + static_cast<std::ptrdiff_t>(form.fixed.size));
  const auto write = [&all](char operation, std::size_t left, std::size_t right) {
    all.push_back({operation, static_cast<std::uint16_t>(left), static_cast<std::uint16_t>(right)});
    return arity<F> + all.size() - 1;
  };
  std::vector<std::size_t> asked;
  for (std::size_t a = 0; a < dimension; ++a) {
    asked.push_back(write('-', arity<F> - dimension + a, certify::side::pivot<F> * dimension + a));
  }
  for (std::size_t i = 0; i < form.query.size; ++i) {
    const Instruction in = form.query.instructions[i];
    asked.push_back(write(in.operation, asked[in.left], asked[in.right]));
  }
  std::size_t sum = 0;
  for (std::size_t v = 0; v < form.variables; ++v) {
    const std::size_t term = write('*', asked[form.variable[v]], form.coefficient[v].number);
    const bool minus = form.coefficient[v].negative != form.coefficient[0].negative;
    sum = v == 0 ? term : write(minus ? '-' : '+', sum, term);
  }
  return all;
}

TYPED_TEST(EveryFormula, HasAFilterThatGappaConfirms) {
  using F = TypeParam;
  const std::vector<certify::tape::Instruction> all = form_instructions<F>();
  const certify::tape::Program form{arity<F>, all};
  EXPECT_EQ(count_terms(form), count_terms(certify::tape::program<F>()));
  if (!gappa::is_installed() || battery::sanitized) return;
  for (const ProofScale scale : {ProofScale::unit, ProofScale::every}) {
    const gappa::Answer answer = gappa::prove(proof_script(F::name, form, certify::side::constant<F>, scale));
    EXPECT_EQ(answer.code, 0) << answer.text;
  }
}
TEST(Sides, GappaRefusesSmallerConstants) {
  if (!gappa::is_installed() || battery::sanitized) return;
  using F = predicates::Orient3d;
  const std::vector<certify::tape::Instruction> all = form_instructions<F>();
  for (const ProofScale scale : {ProofScale::unit, ProofScale::every}) {
    EXPECT_TRUE(gappa::refuses(proof_script(F::name, {arity<F>, all}, certify::side::constant<F> / 2, scale)));
  }
}

// Coordinates whose products underflow: what is told is what the exact stages say.
TYPED_TEST(EveryFormula, TellsOfProductsThatUnderflow) {
  using F = TypeParam;
  int told = 0;
  for (std::uint64_t index = 0; index < 400; ++index) {
    Coordinates<F> c = one_against<F>(Family::grid, index, 1)[0];
    const int exponent = -1074 / static_cast<int>(F::dimension + 1) - static_cast<int>(index % 40) + 20;
    for (double& x : c) x = std::ldexp(x, exponent);
    const Side<F> side = side_of<F>(c);
    const auto q = Arrays<F>::point_of(&c[arity<F> - certify::side::dimension<F>]);
    const Sign truth = decide_exactly<F>(c).sign;
    EXPECT_EQ(side(q), truth) << index;
    told += truth != Sign::zero ? 1 : 0;
    const int filtered = side.filter(q);
    EXPECT_TRUE(filtered == 0 || static_cast<Sign>(filtered) == truth) << index;
  }
  EXPECT_GE(told, 100);
}

TYPED_TEST(EveryFormula, FiltersAsSurelyAsTheFunction) {
  using F = TypeParam;
  StageCounts by_side, by_function;
  for (std::uint64_t index = 0; index < 2000; ++index) {
    const Coordinates<F> c = one_against<F>(Family::uniform, index, 1)[0];
    side_of<F>(c)(Arrays<F>::point_of(&c[arity<F> - certify::side::dimension<F>]), by_side);
    decide<F>(c, by_function);
  }
  EXPECT_GE(by_side.of(Stage::filter), 1998u);
  EXPECT_EQ(by_side.total(), by_function.total());
}

TEST(Sides, SayWhatTheyMean) {
  const LineSide left({0, 0}, {1, 0});
  EXPECT_EQ(left({5, 1}), Sign::positive);
  EXPECT_EQ(left({5, -1}), Sign::negative);
  EXPECT_EQ(left({5, 0}), Sign::zero);
  const PlaneSide below{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(below({3, 3, -1}), Sign::positive);
  EXPECT_EQ(below({3, 3, 1}), Sign::negative);
  EXPECT_EQ(below({3, 3, 0}), Sign::zero);
  const CircleSide inside{{1, 0}, {0, 1}, {-1, 0}};
  EXPECT_EQ(inside({0, 0}), Sign::positive);
  EXPECT_EQ(inside({0, -1}), Sign::zero);
  EXPECT_EQ(inside({0, -2}), Sign::negative);
  const SphereSide within{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}, {-1, 0, 0}};
  EXPECT_EQ(within({0, 0, 0}), orient3d({1, 0, 0}, {0, 0, 1}, {0, 1, 0}, {-1, 0, 0}));
  EXPECT_EQ(within({0, 0, -1}), Sign::zero);
}

// Degenerate lines and planes are such: every point is on them.
TEST(Sides, OfPointsThatCoincideAreZeroEverywhere) {
  const PlaneSide plane{{1, 1, 1}, {1, 1, 1}, {2, 3, 4}};
  EXPECT_EQ(plane({0, 5, 1e300}), Sign::zero);
  const LineSide line({1e-320, 1}, {1e-320, 1});
  EXPECT_EQ(line({1e308, -1e308}), Sign::zero);
}

}  // namespace
}  // namespace plumb::batches
