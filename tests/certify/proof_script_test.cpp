// Does Gappa confirm every bound that was derived, and does it refuse those that are too small?
#include "plumb/certify/proof_script.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <sstream>
#include <vector>

#include "certify/case_line.hpp"
#include "certify/catalog.hpp"
#include "certify/gappa.hpp"
#include "certify/sanitized.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/sign_of.hpp"

namespace plumb {
namespace {

using testing::HasSubstr;

/// A user's own, with everything in it: coordinates beside differences, a sum, products of products.
struct Own {
  static constexpr std::string_view name = "own";
  static constexpr int points = 3, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 6>& p) const {
    const auto s = p[0] + p[1], d = p[2] - p[3];
    return (s * d - p[4] * p[5]) * (d * p[4] + d * d) - p[0] * p[0] * (p[1] - p[2]) * p[5];
  }
};

constexpr auto focal_paraboloid = [](auto x, auto y, auto z, auto f) { return f * z - x * x - y * y; };
constexpr auto unit_paraboloid = [](auto x, auto y, auto z) { return z - x * x - y * y; };
constexpr auto discriminant = [](auto a, auto b, auto c) { return b * b - 4 * a * c; };
// Whole numbers that take sums beside doublings, of a difference and of a product; an opposite.
constexpr auto weighted = [](auto a, auto b, auto c, auto d) { return -5 * (a - b) * c + 3 * (b * d) - 14 * a * a; };
using Discriminant = FormulaOf<decltype(discriminant), double, double, double>::Type;
using Weighted = FormulaOf<decltype(weighted), Point2, Point2>::Type;
using FocalParaboloid = FormulaOf<decltype(focal_paraboloid), Point3, double>::Type;
using UnitParaboloid = FormulaOf<decltype(unit_paraboloid), Point3>::Type;

struct Claim {
  std::string name;
  certify::tape::Program program;
  double constant;

  [[nodiscard]] std::string script(ProofScale scale, double factor = 1) const {
    return proof_script(name, program, constant * factor, scale);
  }
};

template <Formula F>
Claim claim_of(std::string name) {
  return {std::move(name), certify::tape::program<F>(), filter_constant<F>()};
}

/// The manifest's, and a user's.
std::vector<Claim> claims() {
  std::vector<Claim> all{claim_of<Own>("own"), claim_of<FocalParaboloid>("focal paraboloid"),
                         claim_of<UnitParaboloid>("unit paraboloid"), claim_of<Discriminant>("discriminant"),
                         claim_of<Weighted>("weighted")};
  for (const CatalogEntry& e : catalog()) all.push_back({std::string(e.name), e.program, e.filter_constant});
  return all;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  return at == std::string::npos ? "nowhere: " + what : text.replace(at, what.size(), by);
}

constexpr auto both = {ProofScale::unit, ProofScale::every};

// What Gappa computes, our sanitizers have no part in.
bool gappa_is_asked() { return gappa::is_installed() && !battery::sanitized; }

TEST(ProofScriptTest, GappaProvesEveryBoundInDoubles) {
  if (!gappa_is_asked()) return;
  for (const Claim& c : claims()) {
    const gappa::Answer answer = gappa::prove(c.script(ProofScale::unit));
    EXPECT_EQ(answer.code, 0) << c.name << '\n' << answer.text;
  }
}

TEST(ProofScriptTest, GappaProvesEveryBoundAtEveryScale) {
  if (!gappa_is_asked()) return;
  for (const Claim& c : claims()) {
    const gappa::Answer answer = gappa::prove(c.script(ProofScale::every));
    EXPECT_EQ(answer.code, 0) << c.name << '\n' << answer.text;
  }
}

// A half of the constant could be enough: Gappa knows that half an ulp below a power of two is half the unit that the
// derivation counts with.  A quarter never is, unless nothing was rounded before the last operation.
TEST(ProofScriptTest, GappaRefusesBoundsThatAreTooSmall) {
  if (!gappa_is_asked()) return;
  std::size_t refused = 0;
  for (const Claim& c : claims()) {
    const std::size_t size = c.program.instructions.size();
    if (c.constant < 0x1p-53 || size > 14) continue;  // of a long formula a refusal takes long
    for (const ProofScale scale : both) {
      EXPECT_FALSE(gappa::refuses(c.script(scale))) << c.name;
      EXPECT_TRUE(gappa::refuses(c.script(scale, 0.25))) << c.name;
      ++refused;
    }
  }
  EXPECT_GE(refused, 20U);
}

TEST(ProofScriptTest, GappaRefusesTheClassicsWithHalfTheirConstants) {
  if (!gappa_is_asked()) return;
  for (const CatalogEntry& e : catalog().first(3)) {
    for (const ProofScale scale : both) {
      EXPECT_TRUE(gappa::refuses(proof_script(e.name, e.program, e.filter_constant / 2, scale))) << e.name;
    }
  }
}

TEST(ProofScriptTest, GappaRefusesOtherClaims) {
  if (!gappa_is_asked()) return;
  const std::string unit = proof_script<predicates::Orient2d>(),
                    every = proof_script<predicates::Orient2d>(ProofScale::every);
  EXPECT_TRUE(gappa::refuses(replaced(unit, "ieee_64", "ieee_32")));
  EXPECT_TRUE(gappa::refuses(replaced(unit, "exact = T4 - T5", "exact = T4 + T5")));
  EXPECT_TRUE(gappa::refuses(replaced(unit, "T4 = D0_4 * D3_5", "T4 = D0_4 * D2_4")));
  EXPECT_TRUE(gappa::refuses(replaced(unit, "|d0_4| <= 1", "|d0_4| <= 8")));
  EXPECT_TRUE(gappa::refuses(replaced(unit, "value <= ", "value <= -")));
  EXPECT_TRUE(gappa::refuses(replaced(every, "R1 = D0_4", "R1 = D1_5")));
  EXPECT_TRUE(gappa::refuses(replaced(every, "|t1 -/ r1| <= 0x1p-53", "|t1 -/ r1| <= 0x1p-52")));
}

TEST(ProofScriptTest, ClaimsTheVeryConstantOfTheCode) {
  EXPECT_THAT(proof_script<predicates::Orient2d>(), HasSubstr("\n  |unrounded - exact| <= 0x1.80000003p-51\n"));
  for (const Claim& c : claims()) {
    const std::string script = c.script(ProofScale::unit);
    EXPECT_THAT(script, HasSubstr("# constant of the filter: " + hexadecimal(c.constant) + "\n"));
    EXPECT_THAT(script, HasSubstr("| <= " + hexadecimal(c.constant * count_terms(c.program)) + "\n"));
  }
}

/// How many terms the goals of a script for every scale stand for.
std::size_t terms_in(const std::string& script) {
  std::size_t terms = 0;
  for (std::size_t at = 0; (at = script.find("  # as ", at)) != std::string::npos; ++at) {
    terms += std::stoul(script.substr(at + 7));
  }
  return terms;
}

TEST(ProofScriptTest, SpeaksForEveryTermOfADeterminant) {
  EXPECT_EQ(count_terms(certify::tape::program<predicates::Orient2d>()), 2);
  EXPECT_EQ(count_terms(certify::tape::program<predicates::Orient3d>()), 6);
  EXPECT_EQ(count_terms(certify::tape::program<predicates::InCircle>()), 12);
  EXPECT_EQ(count_terms(certify::tape::program<predicates::InSphere>()), 72);
  for (const CatalogEntry& e : catalog().first(4)) {
    const std::string script = proof_script(e.name, e.program, e.filter_constant, ProofScale::every);
    EXPECT_EQ(static_cast<double>(terms_in(script)), count_terms(e.program)) << e.name;
  }
}

TEST(ProofScriptTest, KeepsNamesOnTheirLine) {
  const certify::tape::Program p = certify::tape::program<predicates::Orient2d>();
  EXPECT_THAT(proof_script("one\n{ 0 in [1,2] } ", p, 0x1p-50), HasSubstr("one { 0 in [1,2] }  true"));
}

TEST(ProofScriptTest, RefusesWhatHasNoProof) {
  EXPECT_THROW(proof_script("nothing", {2, {}}, 0x1p-53), Error);
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double constant : {0.0, -0x1p-50, infinity, infinity - infinity}) {
    EXPECT_THROW(proof_script("wrong", certify::tape::program<predicates::Orient2d>(), constant), Error);
  }
  // (x0 x1 + x0 x1) squared five times has 2^32 terms, all alike.
  std::vector<certify::tape::Instruction> squares{{'*', 0, 1}, {'+', 2, 2}};
  for (std::uint16_t i = 3; i < 8; ++i) squares.push_back({'*', i, i});
  EXPECT_THROW(proof_script("squares", {2, squares}, 0x1p-40), Error);
  squares.pop_back();
  EXPECT_EQ(count_terms({2, squares}), 0x1p16);
  EXPECT_EQ(terms_in(proof_script("squares", {2, squares}, 0x1p-40, ProofScale::every)), 1U);
  // The fourth power of a sum of forty coordinates has 123410 different ones.
  std::vector<certify::tape::Instruction> power{{'*', 0, 0}};
  for (std::uint16_t i = 0; i < 40; ++i) power.push_back({'+', static_cast<std::uint16_t>(40 + i), i});
  power.push_back({'*', 80, 80});
  power.push_back({'*', 81, 81});
  EXPECT_NO_THROW(proof_script("power", {40, power}, 0x1p-40));
  EXPECT_THROW(proof_script("power", {40, power}, 0x1p-40, ProofScale::every), Error);
}

}  // namespace
}  // namespace plumb
