// Has every result of the classic interface the exact sign, and the magnitude that it promises?  Against rationals.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <tuple>

#include "certify/case_line.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/certify/formula.hpp"
#include "plumb/classic.h"
#include "plumb/degenerate/points.hpp"
#include "plumb/predicates/manifest.hpp"

namespace plumb {
namespace {

#ifdef PLUMB_LONG_TESTS
constexpr std::uint64_t cases = 100'000;
#else
constexpr std::uint64_t cases = 1'000;
#endif

constexpr double largest = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();

/// One predicate of the interface, over coordinates point after point.
struct Classic {
  const char* name;
  std::size_t dimension, points;
  double (*value)(const double* p);
  double (*exact)(const double* p);
  double (*fast)(const double* p);
  mpq_class (*rational)(std::span<const double> p);
  Degeneracy degeneracy;
};

template <Formula F>
mpq_class rational(std::span<const double> p) {
  return evaluate<F>([&](std::size_t i) { return big_rational(p[i]); }).value;
}

const Classic classics[] = {
    {"orient2d", 2, 3, [](const double* p) { return orient2d(p, p + 2, p + 4); },
     [](const double* p) { return orient2dexact(p, p + 2, p + 4); },
     [](const double* p) { return orient2dfast(p, p + 2, p + 4); }, rational<predicates::Orient2d>,
     Degeneracy::collinear},
    {"orient3d", 3, 4, [](const double* p) { return orient3d(p, p + 3, p + 6, p + 9); },
     [](const double* p) { return orient3dexact(p, p + 3, p + 6, p + 9); },
     [](const double* p) { return orient3dfast(p, p + 3, p + 6, p + 9); }, rational<predicates::Orient3d>,
     Degeneracy::coplanar},
    {"incircle", 2, 4, [](const double* p) { return incircle(p, p + 2, p + 4, p + 6); },
     [](const double* p) { return incircleexact(p, p + 2, p + 4, p + 6); },
     [](const double* p) { return incirclefast(p, p + 2, p + 4, p + 6); }, rational<predicates::InCircle>,
     Degeneracy::cocircular},
    {"insphere", 3, 5, [](const double* p) { return insphere(p, p + 3, p + 6, p + 9, p + 12); },
     [](const double* p) { return insphereexact(p, p + 3, p + 6, p + 9, p + 12); },
     [](const double* p) { return inspherefast(p, p + 3, p + 6, p + 9, p + 12); }, rational<predicates::InSphere>,
     Degeneracy::cospherical},
};

mpq_class distance(double magnitude, const mpq_class& e) {
  const mpq_class end = mpq_class(mpz_class(1) << 1024);  // where the next double would be
  return abs(std::isinf(magnitude) ? mpq_class(end - e) : mpq_class(mpq_class(magnitude) - e));
}

/// Is x the double nearest to the exact value, ties to even, but not zero unless that is?
bool is_nearest(double x, const mpq_class& exact) {
  if (sgn(exact) == 0) return x == 0 && !std::signbit(x);
  if (x == 0 || std::signbit(x) != (sgn(exact) < 0)) return false;
  const double magnitude = std::fabs(x);
  const mpq_class e = abs(exact), off = distance(magnitude, e);
  const bool even = (std::bit_cast<std::uint64_t>(x) & 1) == 0;
  const auto no_nearer = [&](double neighbor) {
    const mpq_class other = distance(neighbor, e);
    return even ? off <= other : off < other;
  };
  return (magnitude == least || no_nearer(std::nextafter(magnitude, 0))) &&
         (std::isinf(magnitude) || no_nearer(std::nextafter(magnitude, HUGE_VAL)));
}

std::string case_line(const Classic& c, const std::vector<double>& p) { return to_string(CaseLine{c.name, p, {}}); }

class ClassicValues : public testing::TestWithParam<std::tuple<std::size_t, Family>> {};

TEST_P(ClassicValues, HaveTheExactSignAndThePromisedMagnitude) {
  const auto& [which, family] = GetParam();
  const Classic& c = classics[which];
  std::vector<double> p(c.dimension * c.points);
  std::uint64_t zero = 0;
  for (std::uint64_t i = 0; i < cases; ++i) {
    Entropy entropy(41, i);
    fill_points(family, c.degeneracy, static_cast<int>(c.dimension), p, entropy);
    const mpq_class truth = c.rational(p);
    const double value = c.value(p.data()), exact = c.exact(p.data());
    ASSERT_TRUE(is_nearest(exact, truth)) << hexadecimal(exact) << ": " << case_line(c, p);
    ASSERT_EQ(static_cast<int>(value > 0) - static_cast<int>(value < 0), sgn(truth)) << case_line(c, p);
    zero += sgn(truth) == 0;
    const bool rounds = std::fabs(value) < std::numeric_limits<double>::min() || std::isinf(value);
    ASSERT_TRUE(rounds ? is_nearest(value, truth) : abs(mpq_class(value) - truth) * 1000 <= abs(truth))
        << hexadecimal(value) << ": " << case_line(c, p);
  }
  const bool degenerate = family == Family::degenerate_short || family == Family::degenerate_long;
  EXPECT_EQ(zero == cases, degenerate || family == Family::repeated) << zero;
}

INSTANTIATE_TEST_SUITE_P(All, ClassicValues,
                         testing::Combine(testing::Range<std::size_t>(0, std::size(classics)), testing::ValuesIn([] {
                                            std::vector<Family> all;
                                            for (const FamilyInfo& f : families) all.push_back(f.family);
                                            return all;
                                          }())),
                         [](const auto& at) {
                           return std::string(classics[std::get<0>(at.param)].name) + "_" +
                                  std::string(name_of(std::get<1>(at.param)));
                         });

TEST(Classic, PlainFloatingPointIsWrongWhereTheOthersAreNot) {
  for (const Classic& c : classics) {
    std::vector<double> p(c.dimension * c.points);
    int wrong = 0;
    for (std::uint64_t i = 0; i < 1000; ++i) {
      Entropy entropy(43, i);
      fill_points(Family::off_by_ulps, c.degeneracy, static_cast<int>(c.dimension), p, entropy);
      const double fast = c.fast(p.data()), value = c.value(p.data());
      wrong += (fast > 0) != (value > 0) || (fast < 0) != (value < 0);
    }
    EXPECT_GT(wrong, 100) << c.name;
  }
}

TEST(Classic, TheEndsOfTheFormatKeepTheSign) {
  const double huge[] = {largest, 0, 0, largest, -largest, -largest};
  EXPECT_EQ(orient2d(huge, huge + 2, huge + 4), HUGE_VAL);
  EXPECT_EQ(orient2d(huge + 2, huge, huge + 4), -HUGE_VAL);
  const double tiny[] = {least, 0, 0, least, 0, 0};
  EXPECT_EQ(orient2d(tiny, tiny + 2, tiny + 4), least);
  EXPECT_EQ(orient2d(tiny + 2, tiny, tiny + 4), -least);
}

TEST(Classic, NoRealNumberGivesNan) {
  for (const Classic& c : classics) {
    for (const double bad : {HUGE_VAL, -HUGE_VAL, std::numeric_limits<double>::quiet_NaN()}) {
      for (std::size_t at = 0; at < c.dimension * c.points; ++at) {
        std::vector<double> p(c.dimension * c.points);
        for (std::size_t i = 0; i < p.size(); ++i) p[i] = static_cast<double>(i * i % 7);
        p[at] = bad;
        EXPECT_TRUE(std::isnan(c.value(p.data()))) << c.name << ' ' << at;
        EXPECT_TRUE(std::isnan(c.exact(p.data()))) << c.name << ' ' << at;
      }
    }
  }
}

TEST(Classic, SlowAndExactAreOne) {
  exactinit();
  Entropy entropy(42);
  const auto p = coordinates3<5>(Family::off_by_ulps, Degeneracy::cospherical, entropy);
  const double* q = p.data();
  EXPECT_EQ(orient2dslow(q, q + 2, q + 4), orient2dexact(q, q + 2, q + 4));
  EXPECT_EQ(orient3dslow(q, q + 3, q + 6, q + 9), orient3dexact(q, q + 3, q + 6, q + 9));
  EXPECT_EQ(incircleslow(q, q + 2, q + 4, q + 6), incircleexact(q, q + 2, q + 4, q + 6));
  EXPECT_EQ(insphereslow(q, q + 3, q + 6, q + 9, q + 12), insphereexact(q, q + 3, q + 6, q + 9, q + 12));
}

}  // namespace
}  // namespace plumb
