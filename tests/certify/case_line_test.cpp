#include "certify/case_line.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "certify/battery.hpp"
#include "plumb/arith/error.hpp"

namespace plumb::battery {
namespace {

std::string refusal(std::string_view line) {
  try {
    parse_case_line(line);
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing";
}

std::string quoted(const char* word) { return std::string("'").append(word).append("'"); }

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(
      a, b, [](double x, double y) { return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y); });
}

TEST(CaseLineTest, ComesBackBitForBit) {
  for (const CatalogEntry& e : catalog()) {
    for (const FamilyInfo& f : families) {
      for (std::uint64_t i = 0; i < battery::fitting<std::uint64_t>(500); ++i) {
        CaseLine c{std::string(e.name), coordinates_of(e, f.family, i), {}};
        if (i % 4 != 0) c.expected = Unsure{static_cast<Sign>(static_cast<int>(i % 4) - 2)};
        const auto back = parse_case_line(to_string(c));
        ASSERT_TRUE(back.has_value());
        ASSERT_EQ(*back, c);
        ASSERT_TRUE(same_bits(back->coordinates, c.coordinates)) << to_string(c);  // -0.0 too
      }
    }
  }
}

TEST(CaseLineTest, IsWrittenAsDocumented) {
  EXPECT_EQ(to_string(CaseLine{"orient2d", {1.5, -0.0, 0x1p-1074, -3, 0, 1}, Unsure{Sign::negative}}),
            "orient2d 0x1.8p+0 -0x0p+0 0x0.0000000000001p-1022 -0x1.8p+1 0x0p+0 0x1p+0 = -");
}

TEST(CaseLineTest, TakesDecimalsBlanksAndRemarks) {
  const auto c = parse_case_line("\t orient2d 0.1 +1e3 -2  0X1.8P-3 .5 5. = +  # a remark = -\r\n");
  ASSERT_TRUE(c.has_value());
  EXPECT_EQ(c->coordinates, (std::vector{0.1, 1000.0, -2.0, 0x1.8p-3, 0.5, 5.0}));
  EXPECT_EQ(c->expected, Unsure{Sign::positive});
  EXPECT_FALSE(parse_case_line("orient2d 0 0 1 0 0 1")->expected.certain());
  EXPECT_FALSE(parse_case_line("orient2d 0 0 1 0 0 1 # = +")->expected.certain());
  for (const char* nothing : {"", "   \t\r\n", "# orient2d 0 0 0 0 0 0", "  #"}) {
    EXPECT_EQ(parse_case_line(nothing), std::nullopt);
  }
}

TEST(CaseLineTest, SaysWhatIsWrong) {
  EXPECT_EQ(refusal("orient4d 0 0"),
            "there is no predicate 'orient4d'; there are orient2d, orient3d, incircle, insphere and " +
                std::to_string(catalog().size() - 4) + " more, which `plumb sign --help` lists");
  EXPECT_EQ(refusal("orient2d 0 0 1 0 0"), "orient2d takes 3 points of 2 coordinates, 6 numbers in all, not 5");
  EXPECT_EQ(refusal("orient2d 0 0 1 0 0 1 2"), "orient2d takes 3 points of 2 coordinates, 6 numbers in all, not 7");
  EXPECT_EQ(refusal("insphere = 0"), "insphere takes 5 points of 3 coordinates, 15 numbers in all, not 0");
  EXPECT_EQ(refusal("orient2d 0 0 1 0 0 1 = +-"), "after '=' comes the expected sign '+', '0' or '-', not '+-'");
  EXPECT_EQ(refusal("orient2d 0 0 1 0 0 1 ="), "after '=' comes the expected sign '+', '0' or '-', not ''");
  EXPECT_EQ(refusal("orient2d 0 0 1 0 0 1 = + 3"), "nothing may follow the sign, but here comes '3'");
  const std::string hint = " is not a number; give a decimal or hexadecimal double, such as 0.1 or 0x1.8p-3";
  for (const char* word :
       {"x", "1.2.3", "1e", "--1", "+-1", "-", "+", "0x", "0xg", "-+0x1", "1,5", "0x1p", "1f", "=0"}) {
    EXPECT_EQ(refusal(std::string("orient2d 0 0 1 0 0 ") + word), quoted(word) + hint);
  }
}

// Found by fuzzing: a NUL cut the message short.
TEST(CaseLineTest, SpellsOutControlCharacters) {
  constexpr std::string_view line("orient2d 0 0 1 0 0 1\0\x1b[m", 24);
  EXPECT_EQ(refusal(line),
            "'1\\x00\\x1b[m' is not a number; give a decimal or hexadecimal double, such as 0.1 or 0x1.8p-3");
}

TEST(CaseLineTest, RefusesWhatIsNoRealNumber) {
  for (const char* word : {"nan", "-nan", "inf", "-inf", "+infinity", "NAN", "nan(1)"}) {
    const std::string line = std::string("orient2d 0 0 1 0 0 ") + word;
    EXPECT_THROW(parse_case_line(line), NonFinite) << word;
    EXPECT_EQ(refusal(line), quoted(word) + " is not a real number; give a finite double");
  }
  EXPECT_EQ(refusal("orient2d 0 0 1 0 0 1e400"), "'1e400' is beyond the largest double");
  EXPECT_EQ(refusal("orient2d 0 0 1 0 0 -0x1p1024"), "'-0x1p1024' is beyond the largest double");
  EXPECT_EQ(parse_double("0x1.fffffffffffffp+1023"), std::numeric_limits<double>::max());
  EXPECT_EQ(parse_double("4.9406564584124654e-324"), std::numeric_limits<double>::denorm_min());
}

TEST(CaseLineTest, ReadsDecimalsToTheNearestDouble) {
  EXPECT_EQ(parse_double("9007199254740993"), 0x1p53);  // halfway, to even
  EXPECT_EQ(parse_double("9007199254740993.0000000000000000000000001"), 0x1p53 + 2);
  EXPECT_EQ(parse_double("0x1.00000000000008p0"), 1.0);
  EXPECT_EQ(parse_double("0x1.000000000000080001p0"), 1 + 0x1p-52);
  EXPECT_TRUE(std::signbit(parse_double("-0")));
}

}  // namespace
}  // namespace plumb::battery
