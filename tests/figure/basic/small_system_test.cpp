// Small systems, determinants and inverses against elimination in rationals, singular ones above all.
#include "plumb/figure/basic/small_system.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "certify/case_line.hpp"
#include "figure/basic/rationals.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/degenerate.hpp"

namespace plumb {
namespace {

using rationals::is_nearest, rationals::Vector;
using testing::HasSubstr;

/// Small integers (often dependent), numbers of a family, or multiples of one another, at any scale.
template <std::size_t N>
Rows<N + 1> numbers(Entropy& entropy) {
  Rows<N + 1> rows{};
  std::array<double, 32> drawn{};
  const std::size_t kind = entropy.below(4);
  if (kind == 3) {
    const Family family = any_family(entropy);
    fill_points(family, Degeneracy::coplanar, 2, drawn, entropy);
  } else {
    for (double& x : drawn) x = static_cast<double>(entropy.within(kind == 0 ? 1 : 5));
  }
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j <= N; ++j) rows[i][j] = drawn[i * (N + 1) + j];
    if (i > 0 && entropy.below(4) == 0) {  // an equation that follows from another, or contradicts it
      const double by = std::ldexp(1.0, static_cast<int>(entropy.within(3)));
      for (std::size_t j = 0; j <= N; ++j) {
        const double x = by * rows[i - 1][j];
        rows[i][j] = std::isfinite(x) ? x : rows[i - 1][j];
      }
      if (entropy.coin()) rows[i][N] = drawn[31];
    }
    if (entropy.below(6) == 0) {
      const int by = static_cast<int>(entropy.within(600));
      for (double& x : rows[i]) {
        if (std::fabs(x) < 0x1p100 && std::fabs(x) > 0x1p-100) x = std::ldexp(x, by);
      }
    }
  }
  return rows;
}

struct Seen {
  int one = 0, none = 0, many = 0, beyond = 0, singular = 0;
};

template <std::size_t N>
void check_system(std::uint64_t index, Seen& seen) {
  SCOPED_TRACE(testing::Message() << N << " equations, start 21 index " << index);
  Entropy entropy(21, index);
  const auto all = numbers<N>(entropy);
  Rows<N> rows{};
  std::array<double, N> right{};
  std::vector<Vector> exact(N);
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < N; ++j) exact[i].emplace_back(rows[i][j] = all[i][j]);
    exact[i].emplace_back(right[i] = all[i][N]);
  }
  const std::size_t rank = rationals::reduce(exact, N).rank, augmented = rationals::reduce(exact, N + 1).rank;
  const auto x = rationals::only_solution(exact);
  if (x && std::ranges::any_of(*x, rationals::overflows)) {
    ++seen.beyond;
    EXPECT_THROW(solve(rows, right), BeyondDoubles);
    return;
  }
  const SystemSolution<N> told = solve(rows, right);
  EXPECT_EQ(told.rank, rank);
  EXPECT_EQ(told.solutions, x ? Solutions::one : augmented > rank ? Solutions::none : Solutions::many);
  ++(x ? seen.one : augmented > rank ? seen.none : seen.many);
  for (std::size_t i = 0; i < N; ++i) EXPECT_TRUE(x ? is_nearest(told.x[i], (*x)[i]) : told.x[i] == 0);
}

template <std::size_t N>
void check_matrix(std::uint64_t index, Seen& seen) {
  SCOPED_TRACE(testing::Message() << N << " rows, start 22 index " << index);
  Entropy entropy(22, index);
  const auto all = numbers<N>(entropy);
  Rows<N> rows{};
  for (std::size_t i = 0; i < N; ++i) std::copy_n(all[i].begin(), N, rows[i].begin());
  // By Leibniz: over all permutations.
  mpq_class determinant_value = 0;
  std::array<std::size_t, N> order{};
  for (std::size_t i = 0; i < N; ++i) order[i] = i;
  do {
    mpq_class product = 1;
    for (std::size_t i = 0; i < N; ++i) {
      product *= mpq_class(rows[i][order[i]]);
      for (std::size_t j = i + 1; j < N; ++j) product *= order[i] > order[j] ? -1 : 1;
    }
    determinant_value += product;
  } while (std::next_permutation(order.begin(), order.end()));
  if (rationals::overflows(determinant_value)) {
    EXPECT_THROW(determinant(rows), BeyondDoubles);
  } else {
    EXPECT_TRUE(is_nearest(determinant(rows), determinant_value));
  }
  bool finite = true;
  std::array<Vector, N> columns;
  for (std::size_t j = 0; j < N && determinant_value != 0; ++j) {
    std::vector<Vector> exact(N);
    for (std::size_t i = 0; i < N; ++i) {
      for (const double x : rows[i]) exact[i].emplace_back(x);
      exact[i].emplace_back(i == j ? 1 : 0);
    }
    columns[j] = *rationals::only_solution(exact);
    for (const mpq_class& x : columns[j]) finite &= !rationals::overflows(x);
  }
  if (!finite) {
    ++seen.beyond;
    EXPECT_THROW(inverse(rows), BeyondDoubles);
    return;
  }
  const auto told = inverse(rows);
  ASSERT_EQ(told.has_value(), determinant_value != 0);
  ++(told ? seen.one : seen.singular);
  for (std::size_t i = 0; i < N && told; ++i) {
    for (std::size_t j = 0; j < N; ++j) EXPECT_TRUE(is_nearest((*told)[i][j], columns[j][i])) << i << j;
  }
}

TEST(SmallSystemTest, SolutionsAreCountedAndRoundedOnce) {
  Seen seen;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    check_system<2>(i, seen);
    check_system<3>(i, seen);
    check_system<4>(i, seen);
  }
  EXPECT_GT(seen.one, 1000);
  EXPECT_GT(seen.none, 300);
  EXPECT_GT(seen.many, 300);
  EXPECT_GT(seen.beyond, 5);
}

TEST(SmallSystemTest, InversesAndDeterminantsAreRoundedOnce) {
  Seen seen;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    check_matrix<2>(i, seen);
    check_matrix<3>(i, seen);
    check_matrix<4>(i, seen);
  }
  EXPECT_GT(seen.one, 500);
  EXPECT_GT(seen.singular, 300);
  EXPECT_GT(seen.beyond, 5);
}

// Two lines meet in a point, are parallel, or the same; however near to that the doubles are.
TEST(SmallSystemTest, LinesMeetAreParallelOrOne) {
  EXPECT_EQ(solve(Rows<2>{{{1, 1}, {1, -1}}}, {3, 1}), (SystemSolution<2>{Solutions::one, 2, {2, 1}}));
  EXPECT_EQ(solve(Rows<2>{{{1, 1}, {2, 2}}}, {3, 1}), (SystemSolution<2>{Solutions::none, 1, {}}));
  EXPECT_EQ(solve(Rows<2>{{{1, 1}, {2, 2}}}, {3, 6}), (SystemSolution<2>{Solutions::many, 1, {}}));
  EXPECT_EQ(solve(Rows<2>{}, {0, 0}), (SystemSolution<2>{Solutions::many, 0, {}}));
  EXPECT_EQ(solve(Rows<2>{}, {0, 0x1p-1074}), (SystemSolution<2>{Solutions::none, 0, {}}));
  EXPECT_EQ(solve(Rows<2>{{{1, 1}, {1, 1 + 0x1p-52}}}, {2, 2}), (SystemSolution<2>{Solutions::one, 2, {2, 0}}));
  EXPECT_EQ(solve(Rows<2>{{{0x1p-1074, 0}, {0, 0x1p-1074}}}, {0x1p-1073, 0}),
            (SystemSolution<2>{Solutions::one, 2, {2, 0}}));
}

// Three planes without a common point: parallel two by two, or a prism; and with a common line.
TEST(SmallSystemTest, ThreePlanes) {
  EXPECT_EQ(solve(Rows<3>{{{1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}, {1, 1, 3}).solutions, Solutions::none);
  EXPECT_EQ(solve(Rows<3>{{{1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}, {1, 1, 2}).solutions, Solutions::many);
  EXPECT_EQ(solve(Rows<3>{{{1, 0, 0}, {1, 0, 0}, {0, 0, 1}}}, {1, 2, 0}).solutions, Solutions::none);
  const auto met = solve(Rows<3>{{{1, 1, 1}, {0, 2, 5}, {2, 5, -1}}}, {6, -4, 27});
  EXPECT_EQ(met, (SystemSolution<3>{Solutions::one, 3, {5, 3, -2}}));
}

TEST(SmallSystemTest, TheBooksDeterminantAndAnInverse) {
  EXPECT_EQ(determinant(Rows<3>{{{4, -2, 6}, {2, 5, 0}, {-2, 1, -4}}}), -24);
  const Rows<2> m{{{2, 1}, {5, 3}}};
  EXPECT_EQ(inverse(m), (Rows<2>{{{3, -1}, {-5, 2}}}));
  EXPECT_EQ(inverse(Rows<2>{{{2, 1}, {4, 2}}}), std::nullopt);
  EXPECT_EQ(determinant(Rows<2>{{{0x1p-800, 0}, {0, 0x1p-800}}}), 0);  // the nearest double, yet not singular:
  EXPECT_EQ(inverse(Rows<2>{{{0x1p-800, 0}, {0, 0x1p-800}}}), (Rows<2>{{{0x1p800, 0}, {0, 0x1p800}}}));
}

TEST(SmallSystemTest, BadInputIsNamed) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  EXPECT_THAT(text_of<NonFinite>([&] {
                solve(Rows<2>{{{1, 2}, {3, nan}}}, {0, 0});
              }),
              HasSubstr("solve: rows[1][1] is nan"));
  EXPECT_THAT(text_of<NonFinite>([&] {
                solve(Rows<2>{{{1, 2}, {3, 5}}}, {0, inf});
              }),
              HasSubstr("solve: right[1] is inf"));
  EXPECT_THAT(text_of<NonFinite>([&] {
                determinant(Rows<2>{{{1, 2}, {-inf, 5}}});
              }),
              HasSubstr("determinant: rows[1][0] is -inf"));
  Rows<4> four{};
  four[3][2] = nan;
  EXPECT_THAT(text_of<NonFinite>([&] { inverse(four); }), HasSubstr("inverse: rows[3][2] is nan"));
  EXPECT_THAT(text_of<BeyondDoubles>([&] {
                solve(Rows<2>{{{0x1p-1074, 0}, {0, 1}}}, {1, 1});
              }),
              HasSubstr("x[0] is beyond"));
  EXPECT_THAT(text_of<BeyondDoubles>([&] {
                determinant(Rows<2>{{{0x1p1000, 0}, {0, 0x1p1000}}});
              }),
              HasSubstr("beyond the largest double"));
}

}  // namespace
}  // namespace plumb
