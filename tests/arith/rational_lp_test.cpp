// Does the simplex method over integers tell optima, refusals and rays that prove themselves?  Small programs with many
// ties, of integers, fractions, and doubles of any size.
#include "arith/rational_lp.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>

#include "plumb/degenerate/coordinates.hpp"

namespace plumb::arith {
namespace {

struct Program {
  RationalVector objective;
  Constraints constraints;
};

/// By `index`: small integers, thirds of them, or doubles of any size.
mpq_class number(Entropy& entropy, std::uint64_t index) {
  const mpq_class small = static_cast<int>(entropy.below(5)) - 2;
  if (index % 4 == 1) return small / static_cast<int>(1 + entropy.below(3));
  if (index % 4 == 2 && entropy.below(2) == 0) return mpq_class(wide_coordinate(entropy));
  return small;
}

RationalVector numbers(Entropy& entropy, std::uint64_t index, std::size_t count) {
  RationalVector r;
  while (r.size() < count) r.push_back(number(entropy, index));
  return r;
}

Program program(std::uint64_t run, std::uint64_t index) {
  Entropy entropy(run, index);
  const std::size_t variables = 1 + entropy.below(5), rows = 1 + entropy.below(12);
  Program p{numbers(entropy, index, variables), {}};
  for (std::size_t i = 0; i < rows; ++i) {
    mpq_class limit = number(entropy, index);
    if (index % 3 == 0) limit = abs(limit);  // the origin meets them all
    p.constraints.add(numbers(entropy, index, variables), limit);
  }
  return p;
}

/// The sum of rows by weights, and of limits.
RationalVector weighted(const Constraints& all, const std::vector<std::size_t>& which, const RationalVector& weights,
                        std::size_t variables) {
  RationalVector sum(variables + 1);
  for (std::size_t k = 0; k < which.size(); ++k) {
    for (std::size_t i = 0; i < variables; ++i) sum[i] += weights[k] * all.rows[which[k]][i];
    sum[variables] += weights[k] * all.limits[which[k]];
  }
  return sum;
}

TEST(RationalLp, ProvesWhatItTells) {
  std::array<int, 3> told{};
  for (std::uint64_t index = 0; index < 6'000; ++index) {
    SCOPED_TRACE(index);
    const auto [objective, constraints] = program(911, index);
    const Optimum best = maximize(objective, constraints);
    ++told[static_cast<std::size_t>(best.kind)];
    if (best.kind == Optimum::Kind::unbounded) {
      EXPECT_GT(dot(objective, best.ray), 0);
      for (const RationalVector& row : constraints.rows) EXPECT_LE(dot(best.ray, row), 0);
      continue;
    }
    for (const mpq_class& w : best.weights) EXPECT_GT(w, 0);
    const RationalVector sum = weighted(constraints, best.deciding, best.weights, objective.size());
    for (std::size_t i = 0; i < objective.size(); ++i) {
      EXPECT_EQ(sum[i], best.kind == Optimum::Kind::optimal ? objective[i] : mpq_class(0));
    }
    if (best.kind == Optimum::Kind::infeasible) {
      EXPECT_LT(sum.back(), 0);
      continue;
    }
    EXPECT_EQ(sum.back(), dot(objective, best.at));
    for (std::size_t j = 0; j < constraints.rows.size(); ++j)
      EXPECT_LE(dot(best.at, constraints.rows[j]), constraints.limits[j]);
  }
  for (const int count : told) EXPECT_GT(count, 500);
}

/// One program after the other, each over the rows that the last one's optimum leaves.
std::optional<RationalVector> one_by_one(const RationalVector& objective, std::vector<RationalVector> rows,
                                         std::vector<RationalVector> limits) {
  RationalVector least;
  for (std::size_t k = 0; k < limits.size(); ++k) {
    const Constraints all{rows, limits[k]};
    const Optimum best = maximize(objective, all);
    if (best.kind != Optimum::Kind::optimal) return {};
    least.push_back(dot(objective, best.at));
    for (std::size_t j = rows.size(); j-- > 0;) {
      if (dot(best.at, all.rows[j]) == all.limits[j]) continue;
      const auto at = static_cast<std::ptrdiff_t>(j);
      rows.erase(rows.begin() + at);
      for (RationalVector& l : limits) l.erase(l.begin() + at);
    }
  }
  return least;
}

TEST(RationalLp, LeastInTurnIsOneProgramAfterTheOther) {
  int some = 0, none = 0;
  for (std::uint64_t index = 0; index < 4'000; ++index) {
    SCOPED_TRACE(index);
    Program p = program(912, index);
    Entropy entropy(913, index);
    std::vector<RationalVector> limits{p.constraints.limits};
    while (limits.size() < 3) limits.push_back(numbers(entropy, index, p.constraints.rows.size()));
    if (index % 2 == 0) {  // weights of the points of a cloud that are one in all: there is always a least
      p.objective.emplace_back(1);
      for (RationalVector& row : p.constraints.rows) row.emplace_back(1);
      for (std::size_t i = 0; i + 1 < p.objective.size(); ++i) p.objective[i] = p.constraints.rows[0][i];
    }
    const auto least = least_in_turn(p.objective, p.constraints.rows, limits);
    EXPECT_EQ(least, one_by_one(p.objective, p.constraints.rows, limits));
    ++(least ? some : none);
  }
  EXPECT_GT(some, 2'000);
  EXPECT_GT(none, 300);
}

TEST(RationalLp, NoRowsAtAll) {
  EXPECT_EQ(maximize({1, 2}, {}).kind, Optimum::Kind::unbounded);
  const Optimum zero = maximize({0, 0}, {});
  EXPECT_EQ(zero.kind, Optimum::Kind::optimal);
  EXPECT_EQ(zero.at, RationalVector(2));
}

}  // namespace
}  // namespace plumb::arith
