#include "import/text.h"

#include <gtest/gtest.h>

namespace candela {
namespace {

TEST(Text, ValidUtf8IsKept) {
    EXPECT_EQ(validUtf8("plain"), "plain");
    EXPECT_EQ(validUtf8("\u00E9\u20AC\U0001F4A1"), "\u00E9\u20AC\U0001F4A1");
    EXPECT_EQ(validUtf8(static_cast<const char*>(nullptr)), "");
}

TEST(Text, InvalidUtf8IsReplaced) {
    EXPECT_EQ(validUtf8("a\xFF"
                        "b"),
              "a\uFFFDb");
    EXPECT_EQ(validUtf8("\xC0\xAF"), "\uFFFD\uFFFD");                      // overlong '/'
    EXPECT_EQ(validUtf8("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD");            // a surrogate
    EXPECT_EQ(validUtf8("\xF4\x90\x80\x80"), "\uFFFD\uFFFD\uFFFD\uFFFD");  // beyond U+10FFFF
    EXPECT_EQ(validUtf8("\xE2\x82"), "\uFFFD\uFFFD");                      // cut off
}

TEST(Text, OneLine) {
    EXPECT_EQ(oneLine("a\nb\tc\x7F"), "a b c ");
    EXPECT_EQ(oneLine("abcdef", 3), "abc...");
}

TEST(Text, JoinedIgnoresTheLocale) {
    EXPECT_EQ(joined("n ", 1234567, " ", 0.5f), "n 1234567 0.5");
}

}  // namespace
}  // namespace candela
