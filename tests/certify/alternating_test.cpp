// Does every swap of two arguments flip the classics' sign?  As an identity of polynomials: the tape, replayed over terms.
#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "certify/battery.hpp"
#include "plumb/certify/decide.hpp"
#include "plumb/degenerate.hpp"

namespace plumb::battery {
namespace {

/// Whole coefficients by the coordinates that a term multiplies, sorted; none is zero.
using Polynomial = std::map<std::vector<std::size_t>, long>;

void add(Polynomial& sum, const std::vector<std::size_t>& term, long coefficient) {
  const auto at = sum.try_emplace(term, 0).first;
  at->second += coefficient;
  if (at->second == 0) sum.erase(at);
}

/// The formula with coordinate at[i] in the place of coordinate i.
Polynomial expanded(certify::tape::Program program, const std::vector<std::size_t>& at) {
  std::vector<Polynomial> value;
  for (const std::size_t i : at) value.push_back({{{i}, 1}});
  for (const certify::tape::Instruction& step : program.instructions) {
    const Polynomial &l = value[step.left], &r = value[step.right];
    Polynomial result;
    if (step.operation == '*') {
      for (const auto& [a, of_a] : l) {
        for (const auto& [b, of_b] : r) {
          std::vector<std::size_t> term;
          std::ranges::merge(a, b, std::back_inserter(term));
          add(result, term, of_a * of_b);
        }
      }
    } else {
      result = l;
      for (const auto& [b, of_b] : r) add(result, b, step.operation == '-' ? -of_b : of_b);
    }
    value.push_back(std::move(result));
  }
  return value.back();
}

Polynomial opposite(Polynomial p) {
  for (auto& [term, coefficient] : p) coefficient = -coefficient;
  return p;
}

template <class F>
struct AlternatingTest : testing::Test {};
using Classics = testing::Types<predicates::Orient2d, predicates::Orient3d, predicates::InCircle, predicates::InSphere>;
TYPED_TEST_SUITE(AlternatingTest, Classics);

TYPED_TEST(AlternatingTest, ASwapMakesTheOppositePolynomial) {
  static_assert(is_alternating<TypeParam>);
  constexpr auto size = static_cast<std::size_t>(TypeParam::dimension);
  const auto program = certify::tape::program<TypeParam>();
  std::vector<std::size_t> given(program.arity);
  for (std::size_t i = 0; i < given.size(); ++i) given[i] = i;
  const Polynomial plain = expanded(program, given);
  ASSERT_GE(plain.size(), 6U);
  for (std::size_t i = 0; i < given.size(); i += size) {
    for (std::size_t k = 0; k < i; k += size) {
      std::vector<std::size_t> swapped = given, equal = given;
      for (std::size_t axis = 0; axis < size; ++axis) {
        std::swap(swapped[i + axis], swapped[k + axis]);
        equal[i + axis] = equal[k + axis];
      }
      EXPECT_EQ(expanded(program, swapped), opposite(plain)) << i << ' ' << k;
      EXPECT_TRUE(expanded(program, equal).empty()) << i << ' ' << k;
    }
  }
}

// Law: an argument that two places hold is found, unless one of them is the last.
TYPED_TEST(AlternatingTest, RepeatedArgumentsAreFound) {
  constexpr auto size = static_cast<std::size_t>(TypeParam::dimension);
  for (std::uint64_t n = 0; n < 200; ++n) {
    Entropy entropy(5, n);
    Coordinates<TypeParam> p;
    for (double& x : p) x = extreme_coordinate(entropy);
    for (std::size_t i = 0; i < p.size(); i += size) {
      for (std::size_t k = 0; k < i; k += size) {
        Coordinates<TypeParam> q = p;
        for (std::size_t axis = 0; axis < size; ++axis) q[i + axis] = q[k + axis] == 0 ? -q[k + axis] : q[k + axis];
        EXPECT_TRUE(i + size == p.size() || certify::repeats_argument<TypeParam>(q));
        q[i + n % size] = q[k + n % size] == 1 ? 2 : 1;
        EXPECT_FALSE(certify::repeats_argument<TypeParam>(q) && !certify::repeats_argument<TypeParam>(p));
      }
    }
  }
}

// Law: the argument that comes last has the least largest coordinate, and the parity is that of its swap.
TYPED_TEST(AlternatingTest, TheLeastArgumentComesLast) {
  const CatalogEntry& e = *find_predicate(TypeParam::name);
  constexpr auto size = static_cast<std::size_t>(TypeParam::dimension);
  int swaps = 0;
  for (std::uint64_t n = 0; n < 1'000; ++n) {
    Coordinates<TypeParam> p{};
    std::ranges::copy(coordinates_of(e, Family::mixture, n), p.begin());
    const certify::LeastLast<TypeParam> seen(p);
    const auto largest = [&](std::size_t i) {
      double most = 0;
      for (std::size_t axis = 0; axis < size; ++axis) most = std::max(most, std::fabs(seen.at[i + axis]));
      return most;
    };
    for (std::size_t i = 0; i < p.size(); i += size) EXPECT_GE(largest(i), largest(p.size() - size));
    EXPECT_EQ(oracle::rational_sign(e.name, seen.at) * seen.parity, oracle::rational_sign(e.name, p));
    swaps += seen.parity == Sign::negative;
  }
  EXPECT_GT(swaps, 300);
  EXPECT_LT(swaps, 950);
}

}  // namespace
}  // namespace plumb::battery
