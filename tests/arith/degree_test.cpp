#include "plumb/arith/degree.hpp"

#include <gtest/gtest.h>

#include "arith/watched.hpp"
#include "certify/sanitized.hpp"
#include "plumb/degenerate.hpp"

namespace plumb {
namespace {

static_assert(degree<predicates::Orient2d>() == 2 && degree<predicates::Orient3d>() == 3);
static_assert(degree<predicates::InCircle>() == 4 && degree<predicates::InSphere>() == 5);
static_assert(degree<Irregular>() == 3 && degree<HighPower>() == 8);

struct Unequal {
  static constexpr std::string_view name = "unequal";
  static constexpr int points = 1, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 2>& p) const {
    return p[0] * p[0] * p[1] - p[1] * p[0] + p[1];
  }
};
static_assert(term_degrees<Unequal>().highest == 3 && !term_degrees<Unequal>().equal);
static_assert(term_degrees<WithConstants>().highest == 3 && term_degrees<WithConstants>().equal);

struct Fits {
  mutable int least_spare = 1 << 20;

  void operator()(const BitLength& b, const mpz_class& exact) const {
    const int used = exact == 0 ? 0 : static_cast<int>(mpz_sizeinbase(exact.get_mpz_t(), 2));
    ASSERT_LE(used, b.bits);
    least_spare = std::min(least_spare, b.bits - used);
  }
  void operator()(const BitLength& b, const mpq_class& exact) const { (*this)(b, exact.get_num()); }
};

TEST(BitLengthTest, NoStepOfAnyFormulaNeedsMore) {
  Entropy entropy(1);
  for_each_formula([&]<Formula F>() {
    SCOPED_TRACE(F::name);
    for (const int bits : {1, 5, 29, 53}) {
      Fits fits;
      for (int i = 0; i < battery::fitting(2'000) && !testing::Test::HasFatalFailure(); ++i) {
        const std::int64_t most = (std::int64_t{1} << bits) - 1;
        evaluate<F>([&](std::size_t) {
          const std::int64_t x = i % 2 == 0 ? (entropy.coin() ? most : -most) : entropy.within(most);
          return watched(BitLength{bits}, mpq_class(static_cast<long>(x)), &fits);
        });
      }
      EXPECT_LE(fits.least_spare, 1);  // some step fills its bits
    }
  });
}

// Homogeneous: scaling all coordinates by 2^k scales the value by 2^(k * degree).
TEST(DegreeTest, IsThatOfTheExactValue) {
  Entropy entropy(2);
  for_each_formula([&]<Formula F>() {
    const auto value = [&](const mpq_class& factor, const Coordinates<F>& p) {
      struct Nothing {
        void operator()(int, const mpq_class&) const {}
      } nothing;
      return evaluate<F>([&](std::size_t i) { return watched(1, mpq_class(p[i] * factor), &nothing); }).exact;
    };
    Coordinates<F> p{};
    for (double& x : p) x = grid_coordinate(entropy, 20);
    mpq_class power = 1;
    for (int i = 0; i < degree<F>(); ++i) power *= 8;
    EXPECT_TRUE(value(8, p) == power * value(1, p)) << F::name;
    EXPECT_TRUE(value(1, p) != 0) << F::name;
  });
}

}  // namespace
}  // namespace plumb
