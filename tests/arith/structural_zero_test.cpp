#include "plumb/arith/structural_zero.hpp"

#include <gtest/gtest.h>

#include "arith/samples.hpp"
#include "arith/watched.hpp"
#include "certify/sanitized.hpp"
#include "plumb/arith/filtered.hpp"

namespace plumb {
namespace {

using samples::rational;

struct Honest {
  mutable long certain = 0, zero = 0;
  void operator()(const StructuralZero& x, const mpq_class& exact) const {
    certain += x.certain;
    zero += exact == 0;
    ASSERT_TRUE(!x.certain || exact == 0);
  }
};

TEST(StructuralZeroTest, IsCertainOfTrueZerosOnlyAtEveryStep) {
  for_each_formula([]<Formula F>() {
    SCOPED_TRACE(F::name);
    Honest honest;
    for (const FamilyInfo& f : families) {
      Entropy entropy(5, static_cast<std::uint64_t>(f.family));
      Coordinates<F> p{};
      for (int i = 0; i < battery::fitting(2'000) && !testing::Test::HasFatalFailure(); ++i) {
        fill_points(f.family, Degeneracy::collinear, F::dimension, p, entropy);
        evaluate<F>([&](std::size_t k) { return watched(StructuralZero::Input{p[k]}, rational(p[k]), &honest); });
      }
    }
    EXPECT_GT(honest.certain, battery::fitting(1'000));
    if (battery::reaches_rare) {  // zeros by cancellation are left to arithmetic
      EXPECT_GT(honest.zero, honest.certain);
    }
  });
}

constexpr StructuralZero::Input zero{0.0}, minus_zero{-0.0}, one{1.0}, minus_one{-1.0}, least{0x1p-1074};
static_assert((zero - minus_zero).certain && (one - one).certain && (one + minus_one).certain);
static_assert(!(one - minus_one).certain && !(least - zero).certain && !(one + one).certain);
static_assert((StructuralZero(zero) * StructuralZero(one)).certain &&
              !(StructuralZero(least) * StructuralZero(least)).certain);
static_assert(!(StructuralZero(zero) + StructuralZero(one)).certain);
static_assert(!(StructuralZero(one) - StructuralZero(one)).certain, "values are not compared beyond coordinates");

}  // namespace
}  // namespace plumb
