#include "core/base/plain_text.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

TEST(PlainText, ShowsWhatATerminalWouldObey) {
  EXPECT_EQ(plainText("a\x1b[0m\n"), "a\\x1b[0m\\x0a");
  EXPECT_EQ(plainText("gr\xc3\xbcn \xff"), "gr\xc3\xbcn \\xff");
  // Characters that change the direction of text, end lines or take no room.
  EXPECT_EQ(plainText("a\u202e\u2066\u200e\u061cz"),
            "a\\xe2\\x80\\xae\\xe2\\x81\\xa6\\xe2\\x80\\x8e\\xd8\\x9cz");
  EXPECT_EQ(plainText("\u200b\u2028\ufeff\U000e0041"),
            "\\xe2\\x80\\x8b\\xe2\\x80\\xa8\\xef\\xbb\\xbf\\xf3\\xa0\\x81\\x81");
  // Various scripts, with their joiners.
  for (const char* const text :
       {"\u0645\u06cc\u200c\u062e", "\U0001f469\u200d\U0001f680", "\u05d0", "\u00a0"}) {
    EXPECT_EQ(plainText(text), text);
  }
  EXPECT_EQ(plainText("\xc2\x9b"), "\\xc2\\x9b");  // CSI in one character
}

TEST(PlainText, KnowsUtf8) {
  EXPECT_TRUE(isUtf8(bytesOf("gr\xc3\xbcn \xf0\x9f\xa4\x96")));
  EXPECT_FALSE(isUtf8(bytesOf("\xc0\x80")));
  EXPECT_FALSE(isUtf8(bytesOf("\xed\xa0\x80")));
  EXPECT_FALSE(isUtf8(bytesOf("\xe2\x82")));
}

TEST(PlainLine, ShowsOneLineSafely) {
  EXPECT_EQ(plainLine(bytesOf("a\nb\tc\x1b[0m\r\nd"), 2), "b c\\x1b[0m");
  EXPECT_EQ(plainLine(bytesOf("a"), 2), "");
  const std::string line = plainLine(bytesOf(std::string(1000, 'x')), 1);
  EXPECT_EQ(line.size(), 163U);
  EXPECT_TRUE(line.ends_with("xxx..."));
}

TEST(PlainLine, CutsNoCharacterInTwo) {
  std::string text(159, 'x');
  text.append("\xc3\xbc and more");
  const std::string line = plainLine(bytesOf(text), 1);
  EXPECT_EQ(line.size(), 162U);
  EXPECT_TRUE(line.ends_with("xxx..."));
}

}  // namespace
}  // namespace rocinante
