// Do the terms of a formula add up to it?  In integers beyond any rounding, for every formula of the manifest.
#include "certify/proof/terms.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "certify/catalog.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/degenerate/entropy.hpp"

namespace plumb::certify::terms {
namespace {

using Integers = std::vector<mpz_class>;

mpz_class applied(char operation, const mpz_class& left, const mpz_class& right) {
  if (operation == '*') return left * right;
  return operation == '+' ? mpz_class(left + right) : mpz_class(left - right);
}

mpz_class value_of(const certify::tape::Program& program, Integers x) {
  for (const certify::tape::Instruction& i : program.instructions)
    x.push_back(applied(i.operation, x[i.left], x[i.right]));
  return x.back();
}

/// Of all nodes.
Integers values_of(const Expanded& expanded, const certify::tape::Program& program, const Integers& x) {
  Integers values;
  for (const Node& n : expanded.nodes) {
    switch (n.step) {
      case Step::coordinate:
        values.push_back(x[n.left]);
        break;
      case Step::leaf: {
        const certify::tape::Instruction& i = program.instructions[n.left];
        values.push_back(applied(i.operation, x[i.left], x[i.right]));
        break;
      }
      case Step::rounded:
        values.push_back(values[n.left]);
        break;
      default:
        values.push_back(applied("xd*+-r"[static_cast<std::size_t>(n.step)], values[n.left], values[n.right]));
    }
  }
  return values;
}

Integers coordinates_below(long limit, std::size_t count, Entropy& entropy) {
  Integers x(count);
  for (mpz_class& at : x) {
    at = static_cast<long>(entropy.below(static_cast<std::uint64_t>(2 * limit))) - limit;
  }
  return x;
}

TEST(TermsTest, AddUpToTheFormula) {
  Entropy entropy(17);
  for (const CatalogEntry& e : catalog()) {
    const Expanded expanded = expand(e.program);
    for (int round = 0; round < 20; ++round) {
      const Integers x = coordinates_below(1'000'000'000, e.arity(), entropy);
      const Integers values = values_of(expanded, e.program, x);
      mpz_class sum = 0;
      for (const Term& t : expanded.terms) {
        if (t.negative) {
          sum -= values[t.node];
        } else {
          sum += values[t.node];
        }
      }
      ASSERT_TRUE(sum == value_of(e.program, x)) << e.name;
    }
  }
}

/// Rounded numbers between a coordinate or difference and the end of its term, the most of them.
std::size_t depth(const Expanded& expanded, std::size_t node) {
  const Node& n = expanded.nodes[node];
  if (n.step == Step::coordinate || n.step == Step::leaf) return 0;
  if (n.step == Step::rounded) return 1 + depth(expanded, n.left);
  return std::max(depth(expanded, n.left), depth(expanded, n.right));
}

TEST(TermsTest, PassEveryRoundingButTheLast) {
  const CatalogEntry& e = *find_predicate("orient3d");  // a product, a sum, a product, a sum
  const Expanded expanded = expand(e.program);
  std::multiset<std::size_t> depths;
  for (const Term& t : expanded.terms) depths.insert(depth(expanded, t.node));
  EXPECT_EQ(depths, (std::multiset<std::size_t>{3, 3, 4, 4, 4, 4}));
}

TEST(TermsTest, HaveTheShapeOfTheirComputation) {
  // (x0 - x1)(x2 - x3) + (x0 - x1)(x0 - x1) - x4 (x0 - x3)
  const std::vector<certify::tape::Instruction> steps{{'-', 0, 1}, {'-', 2, 3}, {'*', 5, 6},  {'*', 5, 5},
                                                      {'+', 7, 8}, {'-', 0, 3}, {'*', 4, 10}, {'-', 9, 11}};
  const Expanded expanded = expand({5, steps});
  ASSERT_EQ(expanded.terms.size(), 3U);
  std::multiset<std::string> shapes;
  for (const Term& t : expanded.terms) shapes.insert(shape(expanded, t.node));
  EXPECT_EQ(shapes, (std::multiset<std::string>{"r*xd", "rr*d#3", "rr*dd"}));
}

TEST(TermsTest, OfOneKindAreOne) {
  // x0 x1 + x1 x0 - x0 x1
  const std::vector<certify::tape::Instruction> steps{{'*', 0, 1}, {'*', 1, 0}, {'+', 2, 3}, {'*', 0, 1}, {'-', 4, 5}};
  const Expanded expanded = expand({2, steps});
  ASSERT_EQ(expanded.terms.size(), 1U);
  EXPECT_EQ(expanded.terms.front().count, 3);
  EXPECT_EQ(shape(expanded, expanded.terms.front().node), "-r+r*xxr*#6#5r*#5#6");
}

}  // namespace
}  // namespace plumb::certify::terms
