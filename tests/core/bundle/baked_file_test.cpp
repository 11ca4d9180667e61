#include "core/bundle/baked_file.h"

#include <gtest/gtest.h>

#include <string>

#include "core/base/hash.h"

namespace rocinante {
namespace {

BakedKey someKey() {
  BakedKey key{};
  for (std::size_t i = 0; i < key.size(); ++i) key[i] = static_cast<std::byte>(i + 1);
  return key;
}

Bytes twoSections() {
  return bakedFile(someKey(), {{1, bytesOf("first")}, {0x100, bytesOf("")}, {7, bytesOf("last")}});
}

/// With the table's checksum made right again.
Bytes withTable(Bytes bytes, std::size_t at, unsigned value) {
  bytes[at] = static_cast<std::byte>(value);
  const std::uint32_t crc = crc32(ByteView(bytes).first(112));
  for (std::size_t i = 0; i < 4; ++i) bytes[112 + i] = static_cast<std::byte>(crc >> (8 * i));
  return bytes;
}

std::string faultOf(ByteView bytes) {
  const auto file = BakedFile::parse(bytes, "f");
  return file.ok() ? "" : file.error().text();
}

// docs/baked-cell.md, byte by byte.
TEST(BakedFileTest, HasTheBytesOfItsPage) {
  const Bytes bytes = bakedFile(someKey(), {{3, bytesOf("abc")}});
  std::string expected = "\x8BRKCELL\n";
  expected += std::string(
      "\4\0\0\0"
      "\1\0\0\0",
      8);
  expected += "\1\2\3\4\5\6\7\10\11\12\13\14\15\16\17\20";
  expected += std::string("\107\0\0\0\0\0\0\0", 8);  // 71 in all
  expected += std::string(
      "\3\0\0\0"
      "\302\101\44\65",
      8);  // the CRC of "abc" is 352441C2
  expected += std::string(
      "\104\0\0\0\0\0\0\0"
      "\3\0\0\0\0\0\0\0",
      16);
  EXPECT_EQ(textOf(ByteView(bytes).first(64)), expected);
  EXPECT_EQ(textOf(ByteView(bytes).last(3)), "abc");
  EXPECT_EQ(bytes.size(), 71U);
}

TEST(BakedFileTest, GivesBackItsSections) {
  const Bytes bytes = twoSections();
  const auto file = BakedFile::parse(bytes, "f");
  ASSERT_TRUE(file.ok()) << file.error().text();
  EXPECT_EQ(file->key(), someKey());
  EXPECT_EQ(textOf(*file->section(1)), "first");
  EXPECT_EQ(textOf(*file->section(0x100)), "");
  EXPECT_EQ(textOf(*file->section(7)), "last");
  EXPECT_EQ(file->section(2).error().text(), "the baked cell has no section 2 (f)");
}

TEST(BakedFileTest, AnyFlippedBitAndAnyCutIsSeen) {
  const Bytes whole = twoSections();
  for (std::size_t i = 0; i < whole.size(); ++i) {
    // The key names what the file was made of: it is covered by the table's checksum too.
    for (const unsigned bit : {1U, 16U, 128U}) {
      Bytes damaged = whole;
      damaged[i] ^= static_cast<std::byte>(bit);
      EXPECT_NE(faultOf(damaged), "") << "byte " << i;
    }
    EXPECT_NE(faultOf(ByteView(whole).first(i)), "") << "cut at " << i;
  }
  Bytes longer = whole;
  longer.push_back(std::byte{0});
  EXPECT_EQ(faultOf(longer), "the baked cell has 126 bytes, its table says 125 (f)");
}

TEST(BakedFileTest, ForgedTablesAreRefused) {
  const Bytes whole = twoSections();
  ASSERT_EQ(faultOf(withTable(whole, 40, 1)), "") << "the forger's own checksum is right";
  for (std::size_t i = 0; i < 112; ++i) {
    for (const unsigned value : {0U, 0x7FU, 0xFFU}) {
      const Bytes forged = withTable(whole, i, value);
      const auto file = BakedFile::parse(forged, "f");
      if (!file.ok()) continue;
      for (const BakedFile::Section& section : file->sections()) {
        ASSERT_GE(section.content.data(), forged.data());
        ASSERT_LE(section.content.data() + section.content.size(), forged.data() + forged.size());
      }
    }
  }
  EXPECT_EQ(faultOf(withTable(whole, 88, 1)),
            "section 1 of the baked cell is not where the one before it ends (f)")
      << "two sections of one id";
  EXPECT_EQ(faultOf(withTable(whole, 12, 0xFF)), "the baked cell is cut within its table (f)");
}

TEST(BakedFileTest, AnotherFormatIsNamed) {
  EXPECT_EQ(faultOf(withTable(twoSections(), 8, 9)),
            "the baked cell has format 9, this version reads 4 (f)");
  EXPECT_EQ(faultOf(bytesOf("solid arm")), "this is not a baked cell (f)");
}

}  // namespace
}  // namespace rocinante
