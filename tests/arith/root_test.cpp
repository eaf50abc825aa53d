// Are real roots all found, and do they compare and round as the real numbers that they are?
#include "plumb/arith/root.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "arith/polynomial.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/degenerate/entropy.hpp"

namespace plumb {
namespace {

using Coefficients = std::vector<Rational>;

Coefficients product(const Coefficients& a, const Coefficients& b) {
  Coefficients c(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) c[i + j] = c[i + j] + a[i] * b[j];
  }
  return c;
}
Coefficients vanishing_at(const Rational& x) { return {-x, 1}; }

Rational value(const Coefficients& p, const Rational& x) {
  Rational sum;
  for (std::size_t i = p.size(); i-- > 0;) sum = sum * x + p[i];
  return sum;
}

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();

TEST(RootTest, TellsItsNumbers) {
  const std::vector<Root> of_two = real_roots(Coefficients{-2, 0, 1});
  EXPECT_EQ(of_two[1].floor(), Rational(1));
  EXPECT_EQ(of_two[1].ceil(), Rational(2));
  EXPECT_EQ(of_two[0].floor(), Rational(-2));
  EXPECT_EQ(of_two[0].ceil(), Rational(-1));
  EXPECT_FALSE(of_two[1].rational());
  const auto [low, high] = of_two[1].interval(Rational(1, std::int64_t{1} << 60));
  EXPECT_LE(high - low, Rational(1, std::int64_t{1} << 60));
  EXPECT_TRUE(low * low < Rational(2) && Rational(2) < high * high);
  EXPECT_THROW((void)of_two[0].interval(0), Error);

  // (3 x - 1) (x - 5) (x^2 - 2): rational roots of a polynomial that has others.
  const Coefficients p = product(product({-1, 3}, {-5, 1}), {-2, 0, 1});
  std::vector<std::optional<Rational>> rational;
  for (const Root& r : real_roots(p)) rational.push_back(r.rational());
  ASSERT_EQ(rational.size(), 4u);
  EXPECT_FALSE(rational[0] || rational[2]);
  EXPECT_EQ(rational[1], Rational(1, 3));
  EXPECT_EQ(rational[3], Rational(5));
  EXPECT_EQ(real_roots(p)[3].floor(), Rational(5));
  EXPECT_EQ(real_roots(p)[3].ceil(), Rational(5));
  EXPECT_EQ(Root(-3).rational(), Rational(-3));
  EXPECT_EQ(Root(0), Rational(0));
  EXPECT_EQ(Root(Rational(-7, 2)).floor(), Rational(-4));
  const std::vector<Root> large = real_roots(Coefficients{Rational::from_text("-2e60"), 0, 1});
  EXPECT_EQ(large[1].floor().text(), "1414213562373095048801688724209");
}

// One interval is short beside the other long before they part.
TEST(RootTest, ComparesNumbersOfFarExponents) {
  const std::vector<Root> a = real_roots(Coefficients{-0x1p-249, 0x1p549, 0x1p549, 0x1p-564, -0x1p593});
  const std::vector<Root> b = real_roots(Coefficients{-0x1p-249, 0, 0x1p958, -0x1p43});
  ASSERT_EQ(a.size(), 2u);
  ASSERT_EQ(b.size(), 3u);
  EXPECT_EQ(a[0].rounded(), 0x1p-798);
  EXPECT_EQ(b[1].rounded(), 0x1.6a09e667f3bcdp-604);
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 3; ++j) EXPECT_EQ(a[i] < b[j], j == 2 || (j == 1 && i == 0)) << i << " " << j;
  }
}

TEST(RootTest, FindsTheRootOfTwo) {
  const Coefficients p{-2, 0, 1};
  const std::vector<Root> all = real_roots(p), positive = real_roots(p, 0, 2);
  ASSERT_EQ(all.size(), 2u);
  ASSERT_EQ(positive.size(), 1u);
  EXPECT_EQ(all[1], positive[0]);
  EXPECT_NE(all[0], positive[0]);
  EXPECT_EQ(all[1].rounded(), std::sqrt(2.0));
  EXPECT_EQ(all[0].rounded(), -std::sqrt(2.0));
  EXPECT_EQ(all[1].rounded(Rounding::down), std::nextafter(std::sqrt(2.0), 0));  // nearest is above
  EXPECT_EQ(all[1].rounded(Rounding::up), std::sqrt(2.0));
  EXPECT_EQ(all[0].rounded(Rounding::down), -std::sqrt(2.0));
  EXPECT_LT(all[1], Rational(1.5));
  EXPECT_GT(all[1], Rational(std::nextafter(std::sqrt(2.0), 0)));
  EXPECT_EQ(all[0].sign(), Sign::negative);
  EXPECT_EQ(all[1].sign_of(Coefficients{-4, 0, 2}), Sign::zero);
  EXPECT_EQ(all[1].sign_of(Coefficients{-4, 0, 2, 1}), Sign::positive);
  EXPECT_EQ(all[1].sign_of({}), Sign::zero);
  EXPECT_EQ(all[0].sign_of(Coefficients{-1}), Sign::negative);
}

TEST(RootTest, ComparesRootsOfDifferentPolynomials) {
  const Coefficients of_two{-2, 0, 1};
  const Root root = real_roots(of_two, 0, 2)[0];
  const std::vector<Root> others = real_roots(product(of_two, Coefficients{-3, 0, 0, 1, 7}), 1, 2);
  ASSERT_EQ(others.size(), 1u);
  EXPECT_EQ(others[0], root);
  // (x - r)(x + r) with r^2 = 2 + 2^-200: not the same number, though no double tells.
  const Rational near = Rational(2) + Rational(0x1p-100) * Rational(0x1p-100);
  EXPECT_GT(real_roots(Coefficients{-near, 0, 1}, 0, 2)[0], root);
  EXPECT_EQ(real_roots(Coefficients{-near, 0, 1}, 0, 2)[0].rounded(), root.rounded());
  const Rational third = Rational(1) / Rational(3);
  const std::vector<Root> hidden = real_roots(product(of_two, vanishing_at(third)), 0, 1);
  ASSERT_EQ(hidden.size(), 1u);
  EXPECT_EQ(hidden[0], third);
  EXPECT_EQ(hidden[0], Root(third));
  EXPECT_LT(hidden[0], Rational(1.0 / 3) + Rational(0x1p-50));
}

TEST(RootTest, TakesEachRootOnceWhateverItsMultiplicity) {
  const Coefficients once = vanishing_at(0.5), thrice = product(product(once, once), once);
  const Coefficients p = product(thrice, product({-3, 0, 1}, {-3, 0, 1}));
  const std::vector<Root> roots = real_roots(p);
  ASSERT_EQ(roots.size(), 3u);
  EXPECT_EQ(roots[1], Rational(0.5));
  EXPECT_EQ(roots[2].rounded(), std::sqrt(3.0));
  const auto [lower, upper] = roots[2].interval();
  EXPECT_LT(value(roots[2].polynomial(), lower) * value(roots[2].polynomial(), upper), Rational(0));
}

TEST(RootTest, KeepsTheEndsOfTheRange) {
  const Coefficients p = product(product(vanishing_at(0), vanishing_at(1)), vanishing_at(0.25));
  ASSERT_EQ(real_roots(p, 0, 1).size(), 3u);
  EXPECT_EQ(real_roots(p, 0, 1)[0], Rational(0));
  EXPECT_EQ(real_roots(p, 0, 1)[2], Rational(1));
  EXPECT_EQ(real_roots(p, 0.25, 1).size(), 2u);
  EXPECT_EQ(real_roots(p, 0.25, 0.25).size(), 1u);
  EXPECT_EQ(real_roots(p, 0x1p-1074, 0.125).size(), 0u);
  EXPECT_EQ(real_roots(p, 1, 0).size(), 0u);
  const Rational third = Rational(1) / Rational(3);
  EXPECT_EQ(real_roots(vanishing_at(third), third, third).size(), 1u);
}

TEST(RootTest, RoundsToSubnormalsAndBeyondDoubles) {
  // x^3 = 2^-3222 * 3: a root between 2^-1074 and 2^-1073.
  const Rational tiny = Rational(0x1p-1074) * Rational(0x1p-1074) * Rational(0x1p-1074);
  const Root small = real_roots(Coefficients{-tiny * Rational(3), 0, 0, 1})[0];
  EXPECT_EQ(small.rounded(Rounding::down), 0x1p-1074);
  EXPECT_EQ(small.rounded(), 0x1p-1074);
  EXPECT_EQ(small.rounded(Rounding::up), 0x1p-1073);
  const Root least = real_roots(Coefficients{-tiny, 0, 0, Rational(9)})[0];  // below half of the least double
  EXPECT_EQ(least.rounded(Rounding::down), 0);
  EXPECT_EQ(least.rounded(), 0);
  EXPECT_EQ(least.rounded(Rounding::up), 0x1p-1074);
  const Rational huge = Rational(largest) * Rational(largest);
  const Root large = real_roots(Coefficients{-huge * Rational(3), 0, 1})[1];
  EXPECT_EQ(large.rounded(Rounding::down), largest);
  EXPECT_EQ(large.rounded(), infinity);
  EXPECT_EQ(large.rounded(Rounding::up), infinity);
  EXPECT_EQ(real_roots(Coefficients{-huge * Rational(3), 0, 1})[0].rounded(Rounding::down), -infinity);
  EXPECT_FALSE(std::signbit(real_roots(Coefficients{0, -1, 0, 1})[1].rounded()));
}

TEST(RootTest, RoundsTiesToEven) {
  // Roots half way between doubles, in polynomials that do not show it.
  const Coefficients irrational{-5, 0, 0, 1};
  for (const double even : {0x1p0, 0x1.0000000000002p0, 0x1p-1073, 0x1p100}) {
    const double up = std::nextafter(even, infinity), down = std::nextafter(even, 0);
    const Rational above = (Rational(even) + Rational(up)) / Rational(2);
    const Rational below = (Rational(even) + Rational(down)) / Rational(2);
    for (const Rational& tie : {above, below}) {
      const std::vector<Root> roots =
          real_roots(product(irrational, product(vanishing_at(tie), vanishing_at(tie + Rational(1) / Rational(3)))));
      const auto is_tie = [&](const Root& r) { return r == tie; };
      const auto found = std::find_if(roots.begin(), roots.end(), is_tie);
      ASSERT_NE(found, roots.end());
      EXPECT_EQ(found->rounded(), even);
      EXPECT_EQ(found->rounded(Rounding::down), tie == above ? even : down);
      EXPECT_EQ(found->rounded(Rounding::up), tie == above ? up : even);
    }
  }
}

TEST(RootTest, RefusesZero) {
  EXPECT_THROW(real_roots(Coefficients{0, 0}), InvalidShape);
  EXPECT_THROW(real_roots({}), InvalidShape);
  EXPECT_TRUE(real_roots(Coefficients{7}).empty());
  EXPECT_TRUE(real_roots(Coefficients{7}, 0, 1).empty());
}

// Products of factors with known roots: x - a/b, x^2 - n (n no square), and x^2 + n, which has none; with repetitions.
// A number is a rational part and n: its order is told by squares.
struct Known {
  mpq_class rational;
  int sign = 0, radicand = 0;  // sign * root of radicand, where sign is not 0
};
int compare_known(const Known& a, const Known& b) {
  if (a.sign == 0 && b.sign == 0) return cmp(a.rational, b.rational);
  if (a.sign != 0 && b.sign != 0) return a.sign != b.sign ? a.sign : a.sign * (a.radicand - b.radicand);
  if (a.sign == 0) return -compare_known(b, a);
  if (sgn(b.rational) != a.sign) return a.sign;
  return a.sign * cmp(mpq_class(a.radicand), mpq_class(b.rational * b.rational));
}

TEST(RootTest, FindsAndOrdersPlantedRoots) {
  constexpr int cases = 3000;
  constexpr std::array radicands{2, 3, 5, 6, 7, 10, 11, 13};
  std::map<std::string, int> seen;
  std::vector<std::pair<Root, Known>> previous;
  for (int i = 0; i < cases; ++i) {
    Entropy entropy(2026, static_cast<std::uint64_t>(i));
    Coefficients p{Rational(static_cast<double>(1 + entropy.below(9)))};
    if (entropy.coin()) p[0] = -p[0];
    std::vector<Known> known;
    const int factors = 1 + static_cast<int>(entropy.below(4));
    for (int f = 0; f < factors; ++f) {
      const std::uint64_t kind = entropy.below(3);
      const int n = radicands[entropy.below(radicands.size())];
      Coefficients factor{Rational(n), 0, 1};
      if (kind == 0) {
        Known k;
        k.rational = mpq_class(static_cast<long>(entropy.within(12)), 1 + entropy.below(8));
        k.rational.canonicalize();
        factor = vanishing_at(Rational(BigRational{k.rational}));
        known.push_back(k);
      } else if (kind == 1) {
        factor[0] = -factor[0];
        known.push_back({0, 1, n});
        known.push_back({0, -1, n});
      }
      p = product(p, factor);
      if (entropy.below(4) == 0) p = product(p, factor), ++seen["repeated"];
    }
    std::ranges::sort(known, [](const Known& a, const Known& b) { return compare_known(a, b) < 0; });
    const auto same = [](const Known& a, const Known& b) { return compare_known(a, b) == 0; };
    known.erase(std::unique(known.begin(), known.end(), same), known.end());
    const std::string replay = "Entropy(2026, " + std::to_string(i) + ")";
    const std::vector<Root> roots = real_roots(p);
    ASSERT_EQ(roots.size(), known.size()) << replay;
    for (std::size_t k = 0; k < roots.size(); ++k) {
      const Known& truth = known[k];
      if (truth.sign == 0) {
        ASSERT_EQ(roots[k], Rational(BigRational{truth.rational})) << replay;
        ASSERT_EQ(roots[k].rounded(), Rational(BigRational{truth.rational}).rounded()) << replay;
      } else {
        ASSERT_EQ(roots[k].rounded(), truth.sign * std::sqrt(truth.radicand)) << replay;
      }
      ++seen[truth.sign == 0 ? "rational" : "irrational"];
      const double lower = roots[k].rounded(Rounding::down), upper = roots[k].rounded(Rounding::up);
      ASSERT_LE(Rational(lower), Rational(upper));
      ASSERT_GE(roots[k], Rational(lower)) << replay;
      ASSERT_LE(roots[k], Rational(upper)) << replay;
      ASSERT_TRUE(upper == lower || upper == std::nextafter(lower, infinity)) << replay;
      for (const auto& before : previous) {
        const Root& root = before.first;
        const Known& other = before.second;
        const int c = compare_known(truth, other);
        ASSERT_EQ(roots[k] <=> root, c <=> 0) << replay;
        if (c == 0) ++seen["equal"];
        ASSERT_EQ(root.sign_of(p) == Sign::zero,
                  std::ranges::any_of(known, [&](const Known& x) { return compare_known(x, other) == 0; }))
            << replay;
      }
    }
    // The ends of a range are included.
    const Rational from(-1), to(2);
    const auto in_range = [&](const Root& r) { return r >= from && r <= to; };
    ASSERT_EQ(real_roots(p, from, to).size(), static_cast<std::size_t>(std::ranges::count_if(roots, in_range)))
        << replay;
    previous.clear();
    for (std::size_t k = 0; k < roots.size(); ++k) previous.emplace_back(roots[k], known[k]);
  }
  EXPECT_GT(seen["rational"], cases / 2);
  EXPECT_GT(seen["irrational"], cases / 2);
  EXPECT_GT(seen["repeated"], cases / 4);
  EXPECT_GT(seen["equal"], cases / 20);
}

TEST(PositiveRoots, AreAsManyAsAreIsolated) {
  Entropy entropy(502, 0);
  int several = 0, repeated = 0;
  for (int i = 0; i < 500; ++i) {
    arith::Polynomial p{1};
    const std::uint64_t factors = 1 + entropy.below(4);
    for (std::uint64_t k = 0; k < factors; ++k) {  // x - a, (x - a)^2 + b
      const long a = static_cast<long>(entropy.below(9)) - 4, b = static_cast<long>(entropy.below(3)) - 1;
      const arith::Polynomial factor = k % 2 == 0 ? arith::Polynomial{-a, 1} : arith::Polynomial{a * a + b, -2 * a, 1};
      arith::Polynomial product(p.size() + factor.size() - 1);
      for (std::size_t m = 0; m < p.size(); ++m) {
        for (std::size_t n = 0; n < factor.size(); ++n) product[m + n] += p[m] * factor[n];
      }
      p = product;
    }
    if (p.front() == 0) continue;
    if (entropy.below(2) == 0) {
      for (mpz_class& c : p) c = -c;
    }
    Coefficients coefficients;
    for (const mpz_class& c : p) coefficients.emplace_back(BigRational{mpq_class(c)});
    int positive = 0;
    for (const Root& root : real_roots(coefficients)) positive += root > Rational(0) ? 1 : 0;
    EXPECT_EQ(arith::count_positive_roots(p), positive) << "500 polynomials of Entropy(502, 0), number " << i;
    several += positive > 1 ? 1 : 0;
    repeated += arith::square_free_part(p).size() < p.size() ? 1 : 0;
  }
  EXPECT_GT(several, 50);
  EXPECT_GT(repeated, 50);
}

TEST(PositiveRoots, AreCountedWhateverTheirSizes) {
  // (x - 2^-2000) (x - 2^2000) (x + 1): isolating them takes a step for each bit.
  const mpz_class far = mpz_class(1) << 2000;
  const arith::Polynomial p{far, -far * far - 1 + far, far - far * far - 1, far};
  EXPECT_EQ(arith::count_positive_roots(p), 2);
  EXPECT_EQ(arith::count_positive_roots({1, 2, 1}), 0);
  EXPECT_EQ(arith::count_positive_roots({1, -2, 1}), 1);
  EXPECT_EQ(arith::count_positive_roots({5}), 0);
}

}  // namespace
}  // namespace plumb
