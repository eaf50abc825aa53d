#include "tool/terminal/utf8.hpp"

#include <gtest/gtest.h>

namespace plumb::tool {
namespace {

TEST(Utf8, KeepsWhatIsValid) {
  for (const std::string text : {"", "plain", "\u00e9\u20ac", "\U0001F600\U0010FFFF", "\x7F\n"})
    EXPECT_EQ(in_utf8(text), text);
}

TEST(Utf8, ReplacesEveryByteThatIsNoPartOfACharacter) {
  const std::string mark = "\uFFFD";
  EXPECT_EQ(in_utf8("a\xFF\xFE"), "a" + mark + mark);
  EXPECT_EQ(in_utf8("\xC3"), mark);                                   // cut short
  EXPECT_EQ(in_utf8("\xC3(\xA9"), mark + "(" + mark);                 // interrupted
  EXPECT_EQ(in_utf8("\xC0\xAF"), mark + mark);                        // longer than needed
  EXPECT_EQ(in_utf8("\xE0\x80\xAF"), mark + mark + mark);             // likewise
  EXPECT_EQ(in_utf8("\xED\xA0\x80"), mark + mark + mark);             // half of a pair
  EXPECT_EQ(in_utf8("\xF4\x90\x80\x80"), mark + mark + mark + mark);  // beyond Unicode
  EXPECT_EQ(in_utf8("\xEF\xBF\xBE"), mark + mark + mark);             // not in XML 1.0
}

}  // namespace
}  // namespace plumb::tool
