#include "viewer/serve/byte_range.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

TEST(ByteRange, OfTheThreeForms) {
  EXPECT_EQ(parseByteRange("bytes=0-0", 10), (ByteRange{0, 1}));
  EXPECT_EQ(parseByteRange("bytes=2-5", 10), (ByteRange{2, 4}));
  EXPECT_EQ(parseByteRange("bytes=2-", 10), (ByteRange{2, 8}));
  EXPECT_EQ(parseByteRange("bytes=-3", 10), (ByteRange{7, 3}));
  EXPECT_EQ(parseByteRange("bytes=2-18446744073709551615", 10), (ByteRange{2, 8}));
  EXPECT_EQ(parseByteRange("bytes=-18446744073709551615", 10), (ByteRange{0, 10}));
}

TEST(ByteRange, OutsideTheFileThereIsNothing) {
  EXPECT_EQ(parseByteRange("bytes=10-", 10), ByteRange{});
  EXPECT_EQ(parseByteRange("bytes=0-", 0), ByteRange{});
  EXPECT_EQ(parseByteRange("bytes=-0", 10)->count, 0U);
}

TEST(ByteRange, EverythingElseIsNoRange) {
  for (const char* text :
       {"", "bytes", "bytes=", "bytes=-", "bytes=5", "bytes=5-4", "bytes=a-", "bytes=0x1-",
        "bytes=+1-2", "bytes= 1-2", "bytes=1-2,3-4", "Bytes=1-2", "bytes=18446744073709551616-"}) {
    EXPECT_FALSE(parseByteRange(text, 10)) << text;
  }
}

}  // namespace
}  // namespace rocinante
