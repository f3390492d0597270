#include <gtest/gtest.h>
#include <tendon/base/text.h>

namespace tendon {
namespace {

TEST(Printable, KeepsPrintableText) {
  EXPECT_EQ(Printable("motor 3: 41 \xc2\xb0"
                      "C, \xe2\x82\xac, \xf0\x9f\xa6\xbe"),
            "motor 3: 41 \xc2\xb0"
            "C, \xe2\x82\xac, \xf0\x9f\xa6\xbe");
}

TEST(Printable, EscapesControlCharacters) {
  EXPECT_EQ(Printable("\x1b[31mred\n\x7f"), "\\x1b[31mred\\x0a\\x7f");
  EXPECT_EQ(Printable("\xc2\x9b"
                      "31m"),
            "\\xc2\\x9b31m");
  EXPECT_EQ(Printable(std::string("a\0b", 3)), "a\\x00b");
}

TEST(Printable, EscapesInvalidUtf8) {
  for (const std::string bad :
       {"\x80", "\xc0\xaf", "\xe0\x80\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xf5\x80\x80\x80",
        "\xff", "\xe2\x82", "\xf0\x9f\xa6"}) {
    for (const char letter : Printable(bad)) {
      EXPECT_TRUE(letter >= 0x20 && letter < 0x7f) << Printable(bad);
    }
  }
}

TEST(Printable, MarksTextThatItTruncates) {
  EXPECT_EQ(Printable("abcdef", 6), "abcdef");
  EXPECT_EQ(Printable("abcdef", 5), "abcde...");
  EXPECT_LT(Printable(std::string(1U << 20U, 'x')).size(), 5000U);
}

TEST(Quoted, PutsPrintableTextBetweenQuotes) {
  EXPECT_EQ(Quoted("arm"), "'arm'");
  EXPECT_EQ(Quoted("a\nb"), "'a\\x0ab'");
  EXPECT_EQ(Quoted("abcdef", 5), "'abcde...'");
}

}  // namespace
}  // namespace tendon
