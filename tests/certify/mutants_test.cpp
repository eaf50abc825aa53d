// Would a slip in a formula be noticed?  Every formula is broken in every small way, and the battery of cases must tell
// each broken one from CGAL's answer.
//
// A mutant differs from its formula in one instruction of its tape: another operation, operands in the other order, or
// one operand taken from elsewhere.  A mutant that no case tells apart is either the same polynomial, which is shown by
// evaluating both at random large integers, or a hole in the battery, which fails.
#include <gtest/gtest.h>

#include <iostream>
#include <sstream>

#include "certify/battery.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/certify/detail/exact_stages.hpp"

namespace plumb::battery {
namespace {

using Instructions = std::vector<certify::tape::Instruction>;

struct Mutant {
  Instructions instructions;
  std::string what;
};

std::string told(std::size_t index, const certify::tape::Instruction& i) {
  std::ostringstream s;
  s << '#' << index << " = #" << i.left << ' ' << i.operation << " #" << i.right;
  return s.str();
}

// Every change of one instruction; an operand may become any other number of its kind: another coordinate for a
// coordinate, any earlier result for a result.
std::vector<Mutant> mutants_of(const certify::tape::Program& program) {
  std::vector<Mutant> all;
  const Instructions original(program.instructions.begin(), program.instructions.end());
  for (std::size_t at = 0; at < original.size(); ++at) {
    const auto add = [&](const certify::tape::Instruction& changed) {
      Mutant m{original,
               told(program.arity + at, original[at]).append(" became ").append(told(program.arity + at, changed))};
      m.instructions[at] = changed;
      all.push_back(std::move(m));
    };
    const certify::tape::Instruction is = original[at];
    for (const char operation : {'+', '-', '*'}) {
      if (operation != is.operation) add({operation, is.left, is.right});
    }
    if (is.operation == '-') add({'-', is.right, is.left});
    const auto substitutes = [&](std::uint16_t operand, const auto& with) {
      const bool coordinate = operand < program.arity;
      const std::size_t begin = coordinate ? 0 : program.arity, end = coordinate ? program.arity : program.arity + at;
      for (std::size_t k = begin; k < end; ++k) {
        if (k != operand) with(static_cast<std::uint16_t>(k));
      }
    };
    substitutes(is.left, [&](std::uint16_t k) { add({is.operation, k, is.right}); });
    substitutes(is.right, [&](std::uint16_t k) { add({is.operation, is.left, k}); });
  }
  return all;
}

mpz_class value(const certify::tape::Program& program, std::vector<mpz_class> number) {
  for (const certify::tape::Instruction& i : program.instructions) {
    const mpz_class &l = number[i.left], &r = number[i.right];
    number.push_back(i.operation == '+' ? mpz_class(l + r) : i.operation == '-' ? mpz_class(l - r) : mpz_class(l * r));
  }
  return number.back();
}

// Are two programs one polynomial?  Of degree n at most 2^12, two that differ agree at a random point with coordinates
// of 200 bits with probability below n / 2^200 (Schwartz and Zippel).
bool same_polynomial(const certify::tape::Program& a, const certify::tape::Program& b) {
  Entropy entropy(99);
  for (int i = 0; i < 3; ++i) {
    std::vector<mpz_class> x(a.arity);
    for (mpz_class& c : x) {
      for (int limb = 0; limb < 4; ++limb) c = (c << 50) + mpz_class(static_cast<unsigned long>(entropy.bits(50)));
    }
    if (value(a, x) != value(b, x)) return false;
  }
  return true;
}

struct Judged {
  std::vector<double> coordinates;
  Sign sign;
};

// A few cases of every family, with CGAL's sign; of formulas beyond the classic four also cases at their zeros, which
// the families are not aimed at.
std::vector<Judged> battery_of(const CatalogEntry& e) {
  std::vector<Judged> cases_with_signs;
  const auto add = [&](std::vector<double> p) {
    if (const auto sign = oracle::cgal_sign(e.name, p)) cases_with_signs.push_back({std::move(p), *sign});
  };
  for (std::uint64_t i = 0; i < 60; ++i) {
    if (!is_classic(e)) {
      Entropy entropy(start_of(e), i);
      std::vector<double> tiny(e.arity()), zero(e.arity());
      fill_tiny(1 + static_cast<std::int64_t>(entropy.below(3)), tiny, entropy);
      fill_at_zero(e, zero, entropy);
      add(std::move(tiny));
      add(std::move(zero));
    }
    for (const FamilyInfo& f : families) add(coordinates_of(e, f.family, i));
  }
  return cases_with_signs;
}

bool noticed(const certify::tape::Program& program, const std::vector<Judged>& judged) {
  return std::ranges::any_of(judged,
                             [&](const Judged& c) { return big_integer_sign(program, c.coordinates) != c.sign; });
}

class Mutants : public testing::TestWithParam<std::size_t> {};

TEST_P(Mutants, AreNoticed) {
  const CatalogEntry& e = catalog()[GetParam()];
  const std::vector<Judged> judged = battery_of(e);
  ASSERT_FALSE(judged.empty()) << "CGAL has no " << e.name << ": state it anew in tests/oracle/cgal.cpp";
  ASSERT_FALSE(noticed(e.program, judged));
  const std::vector<Mutant> all = mutants_of(e.program);
  std::size_t killed = 0, equal = 0;
  for (const Mutant& m : all) {
    const certify::tape::Program program{e.program.arity, m.instructions};
    if (noticed(program, judged)) {
      ++killed;
    } else if (same_polynomial(program, e.program)) {
      ++equal;
      std::cout << "the same polynomial: " << m.what << '\n';
    } else {
      ADD_FAILURE() << e.name << ": survived: " << m.what;
    }
  }
  std::cout << e.name << ": " << all.size() << " mutants, " << killed << " noticed, " << equal << " equivalent\n";
  EXPECT_GE(killed, all.size() * 9 / 10);
}

TEST(SamePolynomialTest, LooksAtValuesNotAtInstructions) {
  // (a + b) (a - b) against a a - b b, and against a a + b b.
  const Instructions factored{{'+', 0, 1}, {'-', 0, 1}, {'*', 2, 3}};
  const Instructions squares{{'*', 0, 0}, {'*', 1, 1}, {'-', 2, 3}}, sum{{'*', 0, 0}, {'*', 1, 1}, {'+', 2, 3}};
  EXPECT_TRUE(same_polynomial({2, factored}, {2, squares}));
  EXPECT_FALSE(same_polynomial({2, factored}, {2, sum}));
}

INSTANTIATE_TEST_SUITE_P(All, Mutants, testing::Range<std::size_t>(0, catalog().size()),
                         [](const auto& at) { return std::string(catalog()[at.param].name); });

}  // namespace
}  // namespace plumb::battery
