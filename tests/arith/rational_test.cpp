#include "plumb/arith/rational.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "plumb/arith/error.hpp"

namespace plumb {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double least = std::numeric_limits<double>::denorm_min(), most = std::numeric_limits<double>::max();

TEST(Rational, EveryDoubleIsExact) {
  for (const double x : {0.0, 1.0, -0.1, least, -least, most, -most, 0x1.8p-1060})
    EXPECT_EQ(Rational(x).rounded(), x) << x;
  EXPECT_FALSE(std::signbit(Rational(-0.0).rounded()));
  EXPECT_EQ(Rational(-0.0), Rational(0.0));
  EXPECT_EQ(Rational(), Rational(0.0));
}

TEST(Rational, FieldOperations) {
  const Rational third = Rational(1) / Rational(3), tenth = Rational(1) / Rational(10);
  EXPECT_EQ(third + third + third, Rational(1));
  EXPECT_EQ(third * Rational(3), Rational(1));
  EXPECT_EQ(-(third - Rational(1)), Rational(2) / Rational(3));
  EXPECT_EQ(Rational(2) / Rational(-6), -third);
  EXPECT_NE(tenth, Rational(0.1));  // 0.1 is a little more
  EXPECT_LT(tenth, Rational(0.1));
  EXPECT_GT(tenth, Rational(std::nextafter(0.1, 0.0)));
  EXPECT_EQ(Rational(most) * Rational(most) / Rational(most), Rational(most));
  EXPECT_EQ(third.sign(), Sign::positive);
  EXPECT_EQ((-third).sign(), Sign::negative);
  EXPECT_EQ((third - third).sign(), Sign::zero);
}

TEST(Rational, Text) {
  EXPECT_EQ((Rational(-3) / Rational(8)).text(), "-3/8");
  EXPECT_EQ((Rational(10) / Rational(2)).text(), "5");
  EXPECT_EQ((Rational(3) / Rational(-6)).text(), "-1/2");
}

TEST(Rational, IntegersOfAnyWidth) {
  constexpr std::int64_t low = std::numeric_limits<std::int64_t>::min(),
                         high = std::numeric_limits<std::int64_t>::max();
  constexpr std::uint64_t all = std::numeric_limits<std::uint64_t>::max();
  EXPECT_EQ(Rational(high).text(), "9223372036854775807");  // no double
  EXPECT_EQ(Rational(low).text(), "-9223372036854775808");
  EXPECT_EQ(Rational(all).text(), "18446744073709551615");
  EXPECT_EQ(Rational(-7).text(), "-7");
  EXPECT_EQ(Rational(std::uint8_t{200}).text(), "200");
  EXPECT_EQ(Rational((std::int64_t{1} << 53) + 1) - Rational(0x1p53), Rational(1));
  EXPECT_EQ(Rational(high).to_int64(), high);
  EXPECT_EQ(Rational(low).to_int64(), low);
  EXPECT_EQ(Rational(all).to_int64(), std::nullopt);
  EXPECT_EQ((Rational(high) + 1).to_int64(), std::nullopt);
  EXPECT_EQ(Rational(1, 2).to_int64(), std::nullopt);
  EXPECT_EQ(Rational(-3, -6).text(), "1/2");
  EXPECT_EQ(Rational(0.5, 3).text(), "1/6");
  EXPECT_LT(Rational(1, 3), Rational(1, 2));
}

TEST(Rational, Parts) {
  const Rational x(-22, 8), n = 6;
  EXPECT_EQ(x.numerator(), Rational(-11));
  EXPECT_EQ(x.denominator(), Rational(4));
  EXPECT_EQ(x.floor(), Rational(-3));
  EXPECT_EQ(x.ceil(), Rational(-2));
  EXPECT_EQ((-x).floor(), Rational(2));
  EXPECT_EQ((-x).ceil(), Rational(3));
  EXPECT_FALSE(x.is_integer());
  EXPECT_TRUE(n.is_integer() && n.floor() == n && n.ceil() == n && n.denominator() == Rational(1));
  EXPECT_EQ(Rational().denominator(), Rational(1));
}

TEST(Rational, FromText) {
  const std::vector<std::pair<const char*, Rational>> right{
      {"0", 0},
      {"-0", 0},
      {"12", 12},
      {"+12", 12},
      {"-12", -12},
      {"007", 7},
      {"0.1", Rational(1, 10)},
      {"-.5", -0.5},
      {"3.", 3},
      {"2.5e-3", Rational(1, 400)},
      {"1E+2", 100},
      {"1.25e1", 12.5},
      {"-3/8", Rational(-3, 8)},
      {"6/-4", Rational(-3, 2)},
      {"0.1/7", Rational(1, 70)},
      {"1e2/1e3", Rational(1, 10)},
      {"123456789012345678901234567890", Rational(1234567890123456789) * Rational(100000000000) + Rational(1234567890)},
  };
  for (const auto& [text, x] : right) {
    EXPECT_EQ(Rational::from_text(text), x) << text;
    EXPECT_EQ(Rational::from_text(x.text()), x) << text;
  }
  EXPECT_EQ(Rational::from_text("1e-400").rounded(Rounding::up), least);
  EXPECT_EQ(Rational::from_text("0.1").rounded(), 0.1);
  for (const char* text : {"", "-", ".", "e5", "1e", "1e+-2", "--1", "1 ", " 1", "1/", "/2", "1/2/3", "0x10", "nan",
                           "inf", "1,5", "1.2.3", "1e2.5"}) {
    EXPECT_THAT([&] { (void)Rational::from_text(text); }, ThrowsMessage<Error>(HasSubstr("is no number; give digits")))
        << text;
  }
  EXPECT_THAT([] { (void)Rational::from_text("1/0.0"); },
              ThrowsMessage<Error>(HasSubstr("\"1/0.0\" is a quotient by zero")));
  for (const char* text : {"1e10001", "1e-99999999999", "2e99999999999999999999"}) {
    EXPECT_THAT([&] { (void)Rational::from_text(text); }, ThrowsMessage<Error>(HasSubstr("power of ten beyond")))
        << text;
  }
}

TEST(Rational, RoundedOnce) {
  const Rational third = Rational(1) / Rational(3);
  EXPECT_EQ(third.rounded(), 1.0 / 3.0);
  EXPECT_EQ(third.rounded(Rounding::down), 0x1.5555555555555p-2);
  EXPECT_EQ(third.rounded(Rounding::up), 0x1.5555555555556p-2);
  EXPECT_EQ((-third).rounded(Rounding::down), -0x1.5555555555556p-2);
  const Rational half_least = Rational(least) / Rational(2);
  EXPECT_EQ(half_least.rounded(), 0);
  EXPECT_EQ(half_least.rounded(Rounding::up), least);
  EXPECT_EQ((half_least * Rational(3)).rounded(), 2 * least);  // a tie goes to the even one
  const Rational beyond = Rational(most) * Rational(2);
  EXPECT_EQ(beyond.rounded(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(beyond.rounded(Rounding::down), most);
  EXPECT_EQ(rounded_root(Rounding::nearest, Rational(2)), std::sqrt(2.0));
  EXPECT_EQ(rounded_root(Rounding::down, Rational(1) / Rational(9)), 0x1.5555555555555p-2);
  EXPECT_EQ(rounded_root(Rounding::nearest, Rational(most) * Rational(most)), most);
}

TEST(Rational, IsAValue) {
  Rational a = 0.5;
  const Rational b = a;
  a = a + a;
  EXPECT_EQ(b, Rational(0.5));
  const Rational c = std::move(a);
  EXPECT_EQ(c, Rational(1));
  a = c;
  const Rational& same = a;
  a = same;
  EXPECT_EQ(a, Rational(1));
}

TEST(Rational, WhatIsNoNumberThrows) {
  EXPECT_THAT([] { Rational x(std::nan("")); }, ThrowsMessage<NonFinite>(HasSubstr("nan")));
  EXPECT_THAT([] { Rational x(-std::numeric_limits<double>::infinity()); }, ThrowsMessage<NonFinite>(HasSubstr("inf")));
  EXPECT_THAT([] { return Rational(1) / Rational(0); }, ThrowsMessage<DegeneratePoint>(HasSubstr("zero")));
}

}  // namespace
}  // namespace plumb
