// What a lattice is said to save is never missed: on every input of the lattice the stages named never decide, and
// plain doubles are right where they are said to suffice.
#include "tool/lattice_savings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "plumb/certify/catalog.hpp"
#include "plumb/degenerate/entropy.hpp"

namespace plumb::tool {
namespace {

Sign plain_double(const CatalogEntry& e, std::vector<double> number) {
  for (const Instruction& i : e.program.instructions) {
    const double l = number[i.left], r = number[i.right];
    number.push_back(i.operation == '+' ? l + r : i.operation == '-' ? l - r : l * r);
  }
  return sign_of_number(number.back());
}

// Coordinates on the lattice, with long and short spans, and many equal ones.
std::vector<double> coordinates_on(const Lattice& lattice, std::size_t count, Entropy& entropy) {
  std::vector<double> p(count);
  for (double& x : p) {
    const int length = static_cast<int>(entropy.below(static_cast<std::uint64_t>(std::min(lattice.bits, 53)) + 1));
    const int shift = static_cast<int>(entropy.below(static_cast<std::uint64_t>(lattice.bits - length) + 1));
    x = std::ldexp(static_cast<double>(entropy.bits(length)), lattice.exponent + shift) * (entropy.coin() ? 1 : -1);
  }
  if (entropy.coin()) p[entropy.below(count)] = p[entropy.below(count)];
  return p;
}

TEST(LatticeSavings, SkipNothingThatDecides) {
  int plain = 0, said = 0;
  for (const int bits : {1, 4, 9, 12, 24, 49, 53, 57, 61, 62, 100, 125, 189, 190, 202, 253, 317, 318, 335, 509, 600}) {
    for (const int exponent : {-1074, -1000, -963, -962, -537, -300, -214, -50, 0, 100, 190, 300, 500, 960}) {
      if (exponent + bits > 1024) continue;
      const Lattice lattice{exponent, bits};
      const std::vector<Saving> savings = lattice_savings(lattice);
      for (std::size_t k = 0; k < classics().size(); ++k) {
        const CatalogEntry& e = classics()[k];
        ASSERT_EQ(savings[k].predicate, e.name);
        plain += savings[k].suffices == "plain double";
        said += !savings[k].skips.empty();
        for (std::uint64_t i = 0; i < 40; ++i) {
          Entropy entropy(i);
          const std::vector<double> p = coordinates_on(lattice, e.arity(), entropy);
          const Decision d = e.decide(p);
          const std::string stage(to_string(d.stage));
          EXPECT_EQ((", " + savings[k].skips + ",").find(" " + stage + ","), std::string::npos)
              << e.name << " on 2^" << exponent << ", " << bits << " bits: decided by " << stage;
          if (savings[k].suffices == "plain double") {
            EXPECT_EQ(plain_double(e, p), d.sign) << e.name << " on 2^" << exponent << ", " << bits << " bits";
          }
        }
      }
    }
  }
  EXPECT_GT(plain, 50);
  EXPECT_GT(said, 300);
}

}  // namespace
}  // namespace plumb::tool
