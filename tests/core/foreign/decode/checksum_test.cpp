#include "core/foreign/decode/checksum.h"

#include <gtest/gtest.h>

namespace rocinante::decode {
namespace {

/// The check values of the catalogue of parametrised CRC algorithms, over "123456789".
TEST(Checksum, GivesTheCataloguesCheckValues) {
  const ByteView digits = rocinante::bytesOf(std::string_view("123456789"));
  EXPECT_EQ(checksumOf(ChecksumKind::crc16_ccitt, digits, {}), 0x29B1U);
  EXPECT_EQ(checksumOf(ChecksumKind::crc16_modbus, digits, {}), 0x4B37U);
  EXPECT_EQ(checksumOf(ChecksumKind::crc16_mcrf4xx, digits, {}), 0x6F91U);
  EXPECT_EQ(checksumOf(ChecksumKind::crc32, digits, {}), 0xCBF43926U);
  EXPECT_EQ(checksumOf(ChecksumKind::sum8, digits, {}), 0xDDU);
  EXPECT_EQ(checksumOf(ChecksumKind::xor8, digits, {}), 0x31U);
}

TEST(Checksum, TheBytesBehindCountLikeThoseBefore) {
  const std::string_view whole = "123456789";
  EXPECT_EQ(checksumOf(ChecksumKind::crc16_mcrf4xx, rocinante::bytesOf(whole.substr(0, 5)),
                       rocinante::bytesOf(whole.substr(5))),
            0x6F91U);
}

TEST(Checksum, PositionsCountFromEitherEndAndStayInside) {
  EXPECT_EQ(positionIn(0, 4), 0U);
  EXPECT_EQ(positionIn(-2, 4), 2U);
  EXPECT_EQ(positionIn(4, 4), 4U);
  EXPECT_FALSE(positionIn(5, 4));
  EXPECT_FALSE(positionIn(-5, 4));
  EXPECT_FALSE(positionIn(INT64_MIN, 4));
}

TEST(Checksum, ASumOutsideTheDatagramNeverHolds) {
  Checksum sum{ChecksumKind::crc32, 0, -4, -4, true, {}};
  for (std::size_t bytes = 0; bytes < 4; ++bytes) {
    EXPECT_FALSE(checksumHolds(sum, Bytes(bytes))) << bytes;
  }
  sum.at = 2;
  EXPECT_FALSE(checksumHolds(sum, Bytes(5)));
}

}  // namespace
}  // namespace rocinante::decode
