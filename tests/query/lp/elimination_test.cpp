// Fourier-Motzkin elimination, the simplex method and Seidel's algorithm against one another; projections by
// definition.
#include "plumb/query/lp/elimination.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "certify/sanitized.hpp"
#include "plumb/query/lp/simplex.hpp"
#include "plumb/query/lp/verify.hpp"
#include "query/lp/linear_cases.hpp"

namespace plumb::linear_cases {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

/// Rows of so many variables with numbers up to 2, about a part of which a box is laid.
LinearSystem small_system(Entropy& entropy, std::size_t dimension, std::size_t rows) {
  LinearSystem s;
  for (std::size_t i = 0; i < rows; ++i) {
    std::vector<Rational> row;
    for (std::size_t k = 0; k < dimension; ++k) row.emplace_back(entropy.below(3) == 0 ? 0 : entropy.within(2));
    s.add(std::move(row), Rational(entropy.within(4), 1 + entropy.below(3)));
  }
  for (std::size_t k = 0; k < dimension && entropy.below(3) != 0; ++k) {
    for (const int way : {-1, 1}) {
      std::vector<Rational> axis(dimension);
      axis[k] = way;
      s.add(std::move(axis), 3);
    }
  }
  return s;
}

std::string about(const LinearSystem& s) {
  std::string text;
  for (std::size_t i = 0; i < s.rows.size(); ++i) {
    for (const Rational& x : s.rows[i]) text += x.text() + ' ';
    text += "<= " + s.limits[i].text() + '\n';
  }
  return text;
}

Rational product(std::span<const Rational> a, std::span<const Rational> b) {
  Rational sum;
  for (std::size_t k = 0; k < a.size(); ++k) sum = sum + a[k] * b[k];
  return sum;
}

TEST(Elimination, SolvesWhatTheOthersSolve) {
  int infeasible = 0, total = 0;
  for (const Class c : all_classes) {
    for (std::uint64_t index = 0; index < (battery::sanitized ? 20 : 100); ++index) {
      Maker maker(c, index);
      const Program<3> p = maker.program<3>();
      const LinearSystem system = linear_system(p.halfspaces);
      const LinearProof by_elimination = solve_by_elimination(system);
      const LinearKind kind = maximize(Vector3{0, 0, 0}, p.halfspaces).kind;
      EXPECT_EQ(by_elimination.kind, kind) << maker.about(p);
      ++total, infeasible += kind == LinearKind::infeasible ? 1 : 0;
      if (system.rows.empty()) continue;
      EXPECT_TRUE(verify(std::vector<Rational>(3), system, by_elimination)) << maker.about(p);
      const std::vector<Rational> objective{p.direction.x, p.direction.y, p.direction.z};
      const LinearProof by_simplex = maximize(objective, system);
      const LinearProof by_seidel = proof_of(maximize(p.direction, p.halfspaces));
      ASSERT_EQ(by_simplex.kind, by_seidel.kind) << maker.about(p);
      EXPECT_TRUE(verify(objective, system, by_simplex)) << maker.about(p);
      if (by_simplex.kind == LinearKind::optimal) {
        EXPECT_EQ(product(objective, by_simplex.point), product(objective, by_seidel.point)) << maker.about(p);
      }
      EXPECT_LE(by_simplex.weights.size(), by_simplex.kind == LinearKind::infeasible ? 4u : 3u) << maker.about(p);
    }
  }
  EXPECT_GT(infeasible, total / 10);
  EXPECT_GT(total - infeasible, total / 10);
}

TEST(Elimination, OfMoreVariables) {
  std::array<int, 3> kinds{};
  for (std::uint64_t index = 0; index < (battery::sanitized ? 20 : 120); ++index) {
    Entropy entropy(9431, index);
    const std::size_t dimension = 1 + entropy.below(5);
    const LinearSystem s = small_system(entropy, dimension, 1 + entropy.below(6));
    std::vector<Rational> objective;
    for (std::size_t k = 0; k < dimension; ++k) objective.emplace_back(entropy.within(2));
    const LinearProof best = maximize(objective, s);
    ++kinds[static_cast<std::size_t>(best.kind)];
    EXPECT_TRUE(verify(objective, s, best)) << about(s);
    const LinearProof solution = solve_by_elimination(s);
    EXPECT_EQ(solution.kind == LinearKind::infeasible, best.kind == LinearKind::infeasible) << about(s);
    EXPECT_TRUE(verify(std::vector<Rational>(dimension), s, solution)) << about(s);
    LinearProof mutant = best;
    if (best.kind == LinearKind::unbounded) {
      for (Rational& x : mutant.ray) x = -x;
    } else if (best.weights.empty()) {
      mutant.kind = LinearKind::infeasible;
    } else {
      mutant.weights[0].weight = -mutant.weights[0].weight;
    }
    EXPECT_FALSE(verify(objective, s, mutant)) << about(s);
  }
  for (const int n : kinds) EXPECT_GT(n, battery::sanitized ? 1 : 10);
}

/// Of the points of a lattice of the first variables: which of them others can be found for.
TEST(Elimination, AProjectionIsWhatCanBeCompleted) {
  int in = 0, out = 0, dropped = 0;
  for (std::uint64_t index = 0; index < 30; ++index) {
    Entropy entropy(9432, index);
    const std::size_t dimension = 3 + entropy.below(2), kept = 1 + entropy.below(2);
    const LinearSystem s = small_system(entropy, dimension, 3 + entropy.below(3));
    const LinearSystem shadow = project(s, kept), least = project(s, kept, {.without_redundant = true});
    EXPECT_LE(least.rows.size(), shadow.rows.size());
    dropped += least.rows.size() < shadow.rows.size() ? 1 : 0;
    for (int trial = 0; trial < 12; ++trial) {
      LinearSystem held = s;
      std::vector<Rational> point;
      for (std::size_t k = 0; k < kept; ++k) {
        point.emplace_back(Rational(entropy.within(8), 2));
        for (const int way : {-1, 1}) {
          std::vector<Rational> axis(dimension);
          axis[k] = way;
          held.add(std::move(axis), way == 1 ? point[k] : -point[k]);
        }
      }
      const bool can = maximize(std::vector<Rational>(dimension), held).kind != LinearKind::infeasible;
      (can ? in : out) += 1;
      const LinearProof there{LinearKind::optimal, point, {}, {}};
      EXPECT_EQ(verify(std::vector<Rational>(kept), shadow, there), can) << about(s);
      EXPECT_EQ(verify(std::vector<Rational>(kept), least, there), can) << about(s);
    }
  }
  EXPECT_GT(in, 10);
  EXPECT_GT(out, 10);
  EXPECT_GT(dropped, 2);
}

TEST(Elimination, OfASquareAndATriangle) {
  LinearSystem cube;  // |x| + |y| + |z| <= 1
  for (const int x : {-1, 1}) {
    for (const int y : {-1, 1}) {
      for (const int z : {-1, 1}) cube.add({x, y, z}, 1);
    }
  }
  const LinearSystem square = project(cube, 2, {.without_redundant = true});
  EXPECT_EQ(square.rows.size(), 4u);
  for (std::size_t i = 0; i < square.rows.size(); ++i) EXPECT_EQ(square.limits[i], Rational(1));
  LinearSystem none;
  none.add({1, 1}, 1), none.add({-1, 0}, -1), none.add({0, -1}, Rational(-1, 1'000'000));
  const LinearProof proof = solve_by_elimination(none);
  EXPECT_EQ(proof.kind, LinearKind::infeasible);
  EXPECT_EQ(proof.weights.size(), 3u);
  EXPECT_EQ(solve_by_elimination(project(none, 1)).kind, LinearKind::infeasible);
  const LinearSystem nothing = project(none, 0);
  ASSERT_EQ(nothing.rows.size(), 1u);
  EXPECT_TRUE(nothing.rows[0].empty());
  EXPECT_EQ(nothing.limits[0].sign(), Sign::negative);
  EXPECT_EQ(solve_by_elimination({}).kind, LinearKind::optimal);
  EXPECT_EQ(maximize(std::vector<Rational>{}, {}).kind, LinearKind::optimal);
  EXPECT_EQ(maximize(std::vector<Rational>{1}, {}).kind, LinearKind::unbounded);
}

TEST(Elimination, MisuseThrows) {
  LinearSystem uneven;
  uneven.add({1, 2}, 1), uneven.add({1}, 1);
  EXPECT_THAT([&] { (void)solve_by_elimination(uneven); },
              ThrowsMessage<InvalidShape>(HasSubstr("solve_by_elimination: system.rows[1] has 1 numbers")));
  EXPECT_THAT([&] { (void)maximize(std::vector<Rational>{1}, uneven); },
              ThrowsMessage<InvalidShape>(HasSubstr("maximize: system.rows[0] has 2 numbers")));
  LinearSystem missing;
  missing.rows.push_back({1});
  EXPECT_THAT([&] { (void)project(missing, 1); }, ThrowsMessage<InvalidShape>(HasSubstr("project: system.limits")));
  LinearSystem s;
  s.add({1, 2}, 1);
  EXPECT_THAT([&] { (void)project(s, 3); }, ThrowsMessage<InvalidShape>(HasSubstr("project: dimension 3")));
  LinearSystem many;
  for (int i = 0; i < 20; ++i) many.add({i, i * i, i % 2 == 0 ? 1 : -1}, 1);
  EXPECT_THAT([&] { (void)project(many, 2, {.most_rows = 5}); },
              ThrowsMessage<Error>(HasSubstr("project: without variable 2 there are more than 5 rows")));
  EXPECT_FALSE(verify(std::vector<Rational>{1}, uneven, {}));
}

}  // namespace
}  // namespace plumb::linear_cases
