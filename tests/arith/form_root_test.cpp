// Are roots of forms, and signs at them, those of real arithmetic?  Against arith/isolated_root.hpp, which has no
// limit.
#include "arith/form_root.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <iostream>
#include <random>
#include <vector>

#include "arith/isolated_root.hpp"

namespace plumb::arith {
namespace {

/// As a form, and in powers of t with u = 1 - t.
struct Both {
  Form form;
  Polynomial polynomial;
};

Polynomial times(const Polynomial& p, const Polynomial& q) {
  Polynomial r(p.empty() || q.empty() ? 0 : p.size() + q.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < q.size(); ++j) r[i + j] += p[i] * q[j];
  }
  return r;
}
Both linear(std::int64_t at_0, std::int64_t at_1) {
  return {Form(BriefInteger(at_0), BriefInteger(at_1)), {mpz_class(long{at_0}), mpz_class(long{at_1 - at_0})}};
}
Both operator*(const Both& a, const Both& b) { return {a.form * b.form, times(a.polynomial, b.polynomial)}; }
Both operator+(const Both& a, const Both& b) {
  Polynomial p = a.polynomial;
  for (std::size_t i = 0; i < p.size(); ++i) p[i] += b.polynomial[i];
  return {a.form + b.form, p};
}

class FormRootTest : public testing::Test {
 protected:
  std::int64_t number(int bits) {
    return static_cast<std::int64_t>(random_() >> 1) >> (63 - bits) << (random_() % 3 == 0 ? 0 : 1);
  }
  std::int64_t either(int bits) { return random_() % 2 == 0 ? number(bits) : -number(bits); }
  Both any_linear(int bits) { return linear(either(bits), either(bits)); }
  Both any(int degree, int bits) {
    Both f = any_linear(bits);
    for (int i = 1; i < degree; ++i) f = f * any_linear(bits);
    if (random_() % 2 == 0) return f;
    Both g = any_linear(bits);
    for (int i = 1; i < degree; ++i) g = g * any_linear(bits);
    return f + g;
  }
  /// Those that share a root with p, and those that nearly do.
  Both beside(const Both& p, const Both& factor, int bits) {
    switch (random_() % 4) {
      case 0:
        return factor * any_linear(bits);
      case 1:
        return factor * factor + linear(0, 0) * any_linear(bits);
      case 2:
        return p.form.degree == 2 ? p : factor * any_linear(bits);
      default:
        return any(2, bits);
    }
  }

  std::mt19937_64 random_{2026};
};

TEST_F(FormRootTest, SignsAreThoseOfAnyLength) {
  int roots = 0, zeros = 0, uncertain = 0, cases = 0;
  for (const int bits : {2, 3, 5, 10, 20, 40, 60}) {
    for (int i = 0; i < 120; ++i, ++cases) {
      const int degree = 1 + static_cast<int>(random_() % 3);
      const Both factor = any_linear(bits);
      Both p = factor;
      if (degree == 2) p = random_() % 2 == 0 ? factor * any_linear(bits) : any(2, bits);
      if (degree == 3)
        p = random_() % 2 == 0   ? factor * any(2, bits)
            : random_() % 2 == 0 ? factor * factor * any_linear(bits)
                                 : any(3, bits);
      make_primitive(p.polynomial);
      ASSERT_EQ(p.form.is_zero(), p.polynomial.empty());
      if (p.polynomial.size() < 2) continue;
      const std::array others{beside(p, factor, bits), any_linear(bits), any(2, bits)};
      std::vector<IsolatedRoot> expected = isolated_roots(p.polynomial, 0, 1);
      std::size_t next = 0;
      const std::string which = "bits " + std::to_string(bits) + " case " + std::to_string(i);
      const bool all = visit_roots(p.form, [&](FormRoot& root) {
        EXPECT_LT(next, expected.size()) << which;
        if (next >= expected.size()) return false;
        IsolatedRoot& truth = expected[next++];
        for (const Both& q : others) {
          Polynomial polynomial = q.polynomial;
          while (!polynomial.empty() && polynomial.back() == 0) polynomial.pop_back();
          const int sign = root.sign_of(q.form);
          if (!root.is_certain()) break;
          EXPECT_EQ(sign, sign_at(polynomial, truth)) << which;
          zeros += sign == 0 ? 1 : 0;
        }
        const double down = root.rounded_down();
        if (root.is_certain()) {
          EXPECT_EQ(down, rounded(Rounding::down, truth)) << which;
        }
        uncertain += root.is_certain() ? 0 : 1;
        ++roots;
        return true;
      });
      EXPECT_TRUE(all) << which;
      EXPECT_EQ(next, expected.size()) << which;
    }
  }
  std::cout << cases << " polynomials, " << roots << " roots, " << zeros << " zeros, " << uncertain << " not told\n";
  EXPECT_GT(roots, cases / 3);
  EXPECT_GT(zeros, roots / 4);
  EXPECT_LE(uncertain, roots / 20);
}

// Two roots on either side of a place at which pieces end, nearer to it than doubles of a piece can say.
TEST_F(FormRootTest, RootsBesideTheEndsOfPieces) {
  const auto shifted = [](Both f, int by) {
    for (BriefInteger& c : f.form.c) c = c << by;
    for (mpz_class& c : f.polynomial) c <<= static_cast<mp_bitcnt_t>(by);
    return f;
  };
  const Both one = linear(1, 1);
  int roots = 0, told = 0;
  for (int i = 0; i < 20'000; ++i) {
    const int places = 1 + static_cast<int>(random_() % 4), gap = 40 + static_cast<int>(random_() % 80);
    const std::int64_t parts = std::int64_t{1} << places,
                       at = 1 + static_cast<std::int64_t>(random_() % static_cast<std::uint64_t>(parts - 1));
    const Both end = linear(-at, parts - at), third = linear(number(4) + 1, number(4) + 1);
    Both p = shifted(end * end * third, gap) + linear(-1 - number(3), -1 - number(3)) * one * one;
    while (!p.polynomial.empty() && p.polynomial.back() == 0) p.polynomial.pop_back();
    make_primitive(p.polynomial);
    const int beside = gap / 2 - 2 + static_cast<int>(random_() % 5);
    const Both q = shifted(end, beside) + linear(either(3), either(3));
    std::vector<IsolatedRoot> expected = isolated_roots(p.polynomial, 0, 1);
    std::size_t next = 0;
    visit_roots(p.form, [&](FormRoot& root) {
      if (next >= expected.size()) return false;
      IsolatedRoot& truth = expected[next++];
      ++roots;
      const int sign = root.sign_of(q.form);
      if (!root.is_certain()) return false;
      ++told;
      EXPECT_EQ(sign, sign_at(q.polynomial, truth)) << i;
      return true;
    });
  }
  EXPECT_GT(roots, 20'000);
  EXPECT_GT(told, roots / 2);
}

TEST_F(FormRootTest, IntegersAreExactOrLost) {
  for (int i = 0; i < 3000; ++i) {
    BriefInteger x(static_cast<std::int64_t>(random_())), y(static_cast<std::int64_t>(random_()));
    const auto big = [](const BriefInteger& v) {
      mpz_class sum = 0;
      BriefInteger rest = v;
      for (int bit = v.bits(); bit-- > 0;) {  // by comparisons, not by what is inside
        const BriefInteger power = BriefInteger(1) << bit;
        const bool negative = rest.sign() < 0;
        const BriefInteger less = negative ? rest + power : rest - power;
        if (less.sign() != 0 && (less.sign() < 0) != negative) continue;
        sum += (negative ? -1 : 1) * (mpz_class(1) << static_cast<mp_bitcnt_t>(bit));
        rest = less;
      }
      EXPECT_EQ(rest.sign(), 0);
      return sum;
    };
    mpz_class big_x = big(x), big_y = big(y);
    for (int k = 0; k < 4; ++k) {
      switch (random_() % 4) {
        case 0:
          x = x * y, big_x *= big_y;
          break;
        case 1:
          x = x + y, big_x += big_y;
          break;
        case 2:
          y = y - x, big_y -= big_x;
          break;
        default:
          y = y << static_cast<int>(random_() % 70), big_y = big(y);
          break;
      }
      ASSERT_FALSE(x.is_lost() || y.is_lost());
      ASSERT_EQ(x.sign(), sgn(big_x));
      ASSERT_EQ(y.sign(), sgn(big_y));
    }
    if (i % 30 == 0) {
      ASSERT_EQ(big(x), big_x);
      ASSERT_EQ(big(y), big_y);
    }
  }
  BriefInteger x(3);
  for (int i = 0; i < 12; ++i) x = x * x;
  EXPECT_TRUE(x.is_lost());
  EXPECT_TRUE((x - x).is_lost());
  EXPECT_EQ(x.sign(), 0);
}

}  // namespace
}  // namespace plumb::arith
