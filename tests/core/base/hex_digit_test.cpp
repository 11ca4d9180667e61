#include "core/base/hex_digit.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

TEST(HexDigit, IsReadInEitherCase) {
  EXPECT_EQ(hexDigit('0'), 0);
  EXPECT_EQ(hexDigit('9'), 9);
  EXPECT_EQ(hexDigit('a'), 10);
  EXPECT_EQ(hexDigit('F'), 15);
  for (const char c : {'/', ':', '@', 'G', '`', 'g', '\0', '\xff'}) EXPECT_EQ(hexDigit(c), -1) << c;
}

TEST(PercentByte, NeedsTwoDigitsBehindThePercentSign) {
  EXPECT_EQ(percentByte("a%4f", 1), 'O');
  EXPECT_EQ(percentByte("%00", 0), '\0');
  EXPECT_EQ(percentByte("%FF", 0), '\xff');
  for (const char* const text : {"", "%", "%4", "%4g", "%g4", "4f%", "x4f"}) {
    EXPECT_EQ(percentByte(text, 0), std::nullopt) << text;
  }
  EXPECT_EQ(percentByte("%4f", 3), std::nullopt);
  EXPECT_EQ(percentByte("%4f", 9), std::nullopt);
}

TEST(PercentDecoded, LeavesOtherPercentSigns) {
  EXPECT_EQ(percentDecoded("a%20b%2Fc"), "a b/c");
  EXPECT_EQ(percentDecoded("100%, %2, %zz%41"), "100%, %2, %zzA");
  EXPECT_EQ(percentDecoded("%2541"), "%41");
  EXPECT_EQ(percentDecoded(""), "");
}

}  // namespace
}  // namespace rocinante
