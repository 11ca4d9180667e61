#include "core/base/hash.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

TEST(Crc32, GivesTheCheckValueOfTheStandard) {
  EXPECT_EQ(crc32(bytesOf("123456789")), 0xCBF43926U);
  EXPECT_EQ(crc32({}), 0U);
}

TEST(Crc32, ContinuesAndCombines) {
  const std::string whole = "a timestamped packet log format";
  for (std::size_t cut = 0; cut <= whole.size(); ++cut) {
    SCOPED_TRACE(cut);
    const ByteView first = bytesOf(whole).first(cut);
    const ByteView second = bytesOf(whole).subspan(cut);
    EXPECT_EQ(crc32(second, crc32(first)), crc32(bytesOf(whole)));
    EXPECT_EQ(crc32Combine(crc32(first), crc32(second), second.size()), crc32(bytesOf(whole)));
  }
}

TEST(Sha256, GivesTheExamplesOfFips180) {
  Sha256 hash;
  hash.add(bytesOf("abc"));
  EXPECT_EQ(hexOf(hash.finish()),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  // finish() starts over.
  EXPECT_EQ(hexOf(hash.finish()),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Sha256, TakesNumbersLeastSignificantByteFirst) {
  Sha256 number;
  number.addU64(0x0807060504030201U);
  Sha256 bytes;
  bytes.add(bytesOf("\x01\x02\x03\x04\x05\x06\x07\x08"));
  EXPECT_EQ(number.finish(), bytes.finish());
}

TEST(Xxh3, GivesTheLibrarysCanonicalFormOfNothing) {
  EXPECT_EQ(hexOf(xxh3({})), "99aa06d3014798d86001c324468d497f");
}

TEST(Xxh3, IsTheSameHoweverItIsFed) {
  std::string text;
  for (int i = 0; text.size() < 5'000; ++i) text += std::to_string(i);
  Xxh3 hash;
  std::size_t at = 0;
  for (std::size_t step = 1; at < text.size(); step = step * 2 + 1) {
    const std::string_view part = std::string_view(text).substr(at, step);
    hash.add(bytesOf(part));
    at += part.size();
    EXPECT_EQ(hash.digest(), xxh3(bytesOf(text.substr(0, at))));
  }
}

}  // namespace
}  // namespace rocinante
