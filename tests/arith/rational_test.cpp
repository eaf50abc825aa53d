#include "plumb/arith/rational.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

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
