// Decimals against GMP rationals: the nearest double, exact or not, and the distance moved.
#include "plumb/surface/file/decimal.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <random>

namespace plumb {
namespace {

using Outcome = DecimalReader::Outcome;

mpq_class rational(const std::string& digits, long power) {
  mpz_class ten;
  mpz_ui_pow_ui(ten.get_mpz_t(), 10, static_cast<unsigned long>(std::labs(power)));
  mpq_class value = power < 0 ? mpq_class(mpz_class(digits), ten) : mpq_class(mpz_class(digits) * ten);
  value.canonicalize();
  return value;
}

bool is_nearest(const mpq_class& exact, double value) {
  const mpq_class distance = abs(exact - mpq_class(value));
  for (const double end : {-INFINITY, INFINITY}) {
    const double other = std::nextafter(value, end);
    if (std::isfinite(other) && abs(exact - mpq_class(other)) < distance) return false;
  }
  return true;
}

// One decimal by itself: value, exactness and distance are those of the rational.
void expect_right(const std::string& digits, long power) {
  const std::string text = digits + "e" + std::to_string(power);
  SCOPED_TRACE(text);
  DecimalReader reader;
  double value = 42;
  ASSERT_EQ(reader.read(text, value), Outcome::number);
  const mpq_class exact = rational(digits, power), distance = abs(exact - mpq_class(value));
  EXPECT_TRUE(is_nearest(exact, value));
  EXPECT_EQ(reader.decimals(), 1U);
  EXPECT_EQ(reader.inexact(), distance == 0 ? 0U : 1U);
  if (distance == 0)
    EXPECT_EQ(reader.largest_move(), 0);
  else
    EXPECT_TRUE(reader.largest_move() > 0 && (is_nearest(distance, reader.largest_move()) ||
                                              reader.largest_move() == std::numeric_limits<double>::denorm_min()));
}

TEST(Decimal, AgreesWithRationals) {
  std::mt19937_64 random(20240229);
  for (int round = 0; round < 30000; ++round) {
    std::string digits;
    const int length = 1 + static_cast<int>(random() % (round % 10 == 0 ? 60 : 22));
    for (int k = 0; k < length; ++k) digits += static_cast<char>('0' + random() % (k == 0 ? 9 : 10) + (k == 0));
    if (round % 4 == 0) digits += "000";
    expect_right(digits, static_cast<long>(random() % 60) - 45);
  }
}

TEST(Decimal, AgreesAtTheEdges) {
  for (const char* digits : {"1", "5", "25", "9007199254740991", "9007199254740992", "9007199254740993",
                             "18446744073709551615", "18446744073709551616", "9999999999999999999",
                             "1000000000000000001", "7450580596923828125", "298023223876953125"})
    for (const long power : {-340L, -325L, -324L, -323L, -308L, -100L, -54L, -28L, -27L, -26L, -23L,
                             -22L,  -1L,   0L,    1L,    15L,   22L,   23L,  27L,  100L, 280L})
      expect_right(digits, power);
  expect_right("17976931348623158", 292);  // rounds down to the largest double
}

// The whole expansion of a double is exact, and no shorter or longer neighbor of it.
TEST(Decimal, LongExpansions) {
  std::mt19937_64 random(7);
  for (int round = 0; round < 2000; ++round) {
    double x = std::ldexp(static_cast<double>(random() >> 11), static_cast<int>(random() % 700) - 500);
    if (round == 0) x = std::numeric_limits<double>::denorm_min();
    if (round == 1) x = std::numeric_limits<double>::max();
    if (x == 0) continue;
    std::array<char, 1500> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), x, std::chars_format::fixed, 1074).ptr;
    std::string text(buffer.data(), end);
    DecimalReader reader;
    double value = 0;
    ASSERT_EQ(reader.read(text, value), Outcome::number);
    EXPECT_EQ(value, x);
    EXPECT_EQ(reader.inexact(), 0U) << text;
    ASSERT_EQ(reader.read(text + "1", value), Outcome::number);
    EXPECT_EQ(value, x);
    EXPECT_EQ(reader.inexact(), 1U) << text;
    EXPECT_EQ(reader.largest_move(), std::numeric_limits<double>::denorm_min()) << "1e-1075, never 0";
  }
}

// The largest of many moves, though most are never computed exactly.
TEST(Decimal, LargestMoveOfMany) {
  std::mt19937_64 random(99);
  for (int round = 0; round < 200; ++round) {
    DecimalReader reader;
    mpq_class largest = 0;
    std::uint64_t inexact = 0;
    for (int k = 0; k < 100; ++k) {
      const std::string digits = std::to_string(1 + random() % (k % 3 == 0 ? 1000000 : 9999999999999999999U));
      const long power = static_cast<long>(random() % 12) - 24 + round % 5;
      double value = 0;
      for (int twice = 0; twice < 2; ++twice)
        ASSERT_EQ(reader.read("-" + digits + "e" + std::to_string(power), value), Outcome::number);
      const mpq_class distance = abs(rational(digits, power) + mpq_class(value));
      if (distance > largest) largest = distance;
      inexact += distance == 0 ? 0 : 2;
    }
    EXPECT_EQ(reader.decimals(), 200U);
    EXPECT_EQ(reader.inexact(), inexact);
    EXPECT_TRUE(is_nearest(largest, reader.largest_move()));
  }
}

TEST(Decimal, Spellings) {
  struct Case {
    const char* text;
    double value;
    bool exact;
  };
  for (const auto& [text, expected, exact] : std::initializer_list<Case>{{"1", 1, true},
                                                                         {"+1.50", 1.5, true},
                                                                         {"-.5", -0.5, true},
                                                                         {"5.", 5, true},
                                                                         {"0.1", 0.1, false},
                                                                         {"0100", 100, true},
                                                                         {"1E+2", 100, true},
                                                                         {"12300e-2", 123, true},
                                                                         {"0e99999999999999999999", 0, true},
                                                                         {"0.000e-9", 0, true},
                                                                         {"1e-400", 0, false},
                                                                         {"4e-324", 4e-324, false},
                                                                         {"1e23", 1e23, false},
                                                                         {"1e22", 1e22, true}}) {
    DecimalReader reader;
    double value = 42;
    ASSERT_EQ(reader.read(text, value), Outcome::number) << text;
    EXPECT_EQ(value, expected) << text;
    EXPECT_EQ(reader.inexact(), exact ? 0U : 1U) << text;
  }
  double value = 0;
  DecimalReader reader;
  for (const char* zero : {"-0", "-0.0", "-0e5", "-1e-999"}) {
    ASSERT_EQ(reader.read(zero, value), Outcome::number);
    EXPECT_TRUE(value == 0 && std::signbit(value)) << zero;
  }
}

TEST(Decimal, Refused) {
  DecimalReader reader;
  double value = 42;
  for (const char* text :
       {"", "+", "-", ".", "e5", "1e", "1e+", "1.2.3", "1,5", "0x1p3", "+-1", "--1", "1 ", "abc", "1f"})
    EXPECT_EQ(reader.read(text, value), Outcome::not_decimal) << text;
  for (const char* text : {"nan", "-NaN", "NAN(0)", "inf", "-Infinity", "1.#INF", "-1.#IND", "+inf"})
    EXPECT_EQ(reader.read(text, value), Outcome::not_finite) << text;
  for (const char* text : {"1e309", "-1e99999999999999999999", "1.7976931348623159e308"})
    EXPECT_EQ(reader.read(text, value), Outcome::too_large) << text;
  EXPECT_EQ(value, 42);
  EXPECT_EQ(reader.decimals(), 0U);
}

}  // namespace
}  // namespace plumb
