#include "plumb/arith/sign.hpp"

#include <gtest/gtest.h>

#include <array>
#include <type_traits>

namespace plumb {
namespace {

constexpr std::array all{Sign::negative, Sign::zero, Sign::positive};

TEST(SignTest, FollowsTheRuleOfSigns) {
  for (const Sign s : all) {
    EXPECT_EQ(-(-s), s);
    for (const Sign t : all) {
      EXPECT_EQ(static_cast<int>(s * t), static_cast<int>(s) * static_cast<int>(t));
      EXPECT_EQ(-(s * t), -s * t);
    }
  }
}

TEST(SignTest, OfNumbersAndAsText) {
  EXPECT_EQ(sign_of_number(-0.0), Sign::zero);
  EXPECT_EQ(sign_of_number(0x1p-1074), Sign::positive);
  EXPECT_EQ(sign_of_number(-3), Sign::negative);
  EXPECT_EQ(to_char(Sign::negative), '-');
  EXPECT_EQ(to_char(Sign::zero), '0');
  EXPECT_EQ(to_char(Sign::positive), '+');
}

TEST(UnsureTest, TellsAMissingAnswerFromZero) {
  EXPECT_FALSE(Unsure<Sign>{}.certain());
  EXPECT_TRUE(Unsure{Sign::zero}.certain());
  EXPECT_NE(Unsure<Sign>{}, Unsure{Sign::zero});
  for (const Sign s : all) EXPECT_EQ(Unsure{s}.value(), s);
}

// No stage's answer can be taken for a sign, a number or a truth by accident, nor a sign for one that is certain.
static_assert(!std::is_convertible_v<Unsure<Sign>, Sign> && !std::is_convertible_v<Sign, Unsure<Sign>>);
static_assert(!std::is_convertible_v<Unsure<Sign>, bool> && !std::is_constructible_v<bool, Unsure<Sign>>);
static_assert(!std::is_convertible_v<Unsure<Sign>, int> && !std::is_convertible_v<Sign, int>);

}  // namespace
}  // namespace plumb
