#include <gtest/gtest.h>

#include "core/packet/packet_text.h"
#include "tests/core/packet/fold_text.h"

namespace rocinante {
namespace {

using test::faultsOf;

class PacketHeaderText : public ::testing::Test {
 protected:
  const PacketHeader* read(std::string_view text) { return decoder_.decodeHeader(bytesOf(text)); }
  PacketTextDecoder decoder_;
};

TEST_F(PacketHeaderText, TheLeastThatASenderCanWriteIsEnough) {
  const PacketHeader* const header = read("RK1 me - -");
  ASSERT_NE(header, nullptr);
  EXPECT_EQ(header->source, "me");
  EXPECT_EQ(header->run, "");
  EXPECT_FALSE(header->sequence || header->time_ns || header->part || header->via);
  EXPECT_FALSE(header->restated || header->reset);
}

TEST_F(PacketHeaderText, EveryWordIsRead) {
  const PacketHeader* const header = read(
      "RK1 arm@7f3a 18446744073709551615 1700000000.000000001 restated part=a:b:2/3 by=relay%20one "
      "reset via=r:1:9\n");
  ASSERT_NE(header, nullptr);
  EXPECT_EQ(header->source, "arm");
  EXPECT_EQ(header->run, "7f3a");
  EXPECT_EQ(header->sequence, UINT64_MAX);
  EXPECT_EQ(header->time_ns, 1700000000000000001);
  EXPECT_TRUE(header->restated);
  EXPECT_TRUE(header->reset);
  ASSERT_TRUE(header->part);
  EXPECT_EQ(header->part->id, "a:b");
  EXPECT_EQ(header->part->index, 2U);
  EXPECT_EQ(header->part->count, 3U);
  EXPECT_EQ(header->by, "relay one");
  ASSERT_TRUE(header->via);
  EXPECT_EQ(header->via->relay, "r:1");
  EXPECT_EQ(header->via->sequence, 9U);
}

TEST_F(PacketHeaderText, UnknownWordsAreSkipped) {
  const PacketHeader* const header = read("RK1 me 1 2.5 shiny colour=\xC3\xA9 partly=1 reset");
  ASSERT_NE(header, nullptr);
  EXPECT_TRUE(header->reset);
  EXPECT_EQ(header->time_ns, 2500000000);
}

TEST_F(PacketHeaderText, BlankLinesCommentsCarriageReturnsTabsAndTrailingNulsAreIgnored) {
  const std::string_view text("\r\n# hello\n \t\n\tRK1\t me  1\t- \r\n\r\nremove arm\r\n\0\0", 46);
  EXPECT_EQ(faultsOf(text), "");
  PacketTextDecoder decoder;
  const Packet* const packet = decoder.decode(bytesOf(text));
  ASSERT_NE(packet, nullptr);
  EXPECT_EQ(packet->header.source, "me");
  ASSERT_EQ(packet->statements.size(), 1U);
  EXPECT_EQ(packet->statements[0].name, "arm");
  EXPECT_EQ(packet->statements[0].line, 6U);
}

TEST_F(PacketHeaderText, WhatDoesNotBeginWithTheVersionIsNoPacket) {
  for (const char* const text :
       {"", "\n\n", "# RK1 me - -", "RK2 me - -", "RK10 me - -", "rk1 me - -", "XRK1 me - -",
        "\xEF\xBB\xBFRK1 me - -", "joints arm 1"}) {
    SCOPED_TRACE(text);
    EXPECT_EQ(read(text), nullptr);
    EXPECT_EQ(faultsOf(text), "1 1 not_a_packet\n");
    EXPECT_EQ(encodingOf(bytesOf(text)), "octets");
  }
}

TEST_F(PacketHeaderText, AMalformedHeaderDropsTheDatagramAndSaysWhere) {
  const struct {
    const char* text;
    const char* faults;
  } kCases[] = {
      {"RK1", "1 4 bad_header\n"},
      {"RK1 me", "1 7 bad_header\n"},
      {"RK1 me 1", "1 9 bad_header\n"},
      {"\nRK1 m\xC3\xA9 1 -", "2 5 bad_header\n"},
      {"RK1 @run 1 -", "1 5 bad_header\n"},
      {"RK1 me@ 1 -", "1 5 bad_header\n"},
      {"RK1 me@a@b 1 -", "1 5 bad_header\n"},
      {"RK1 me%00 1 -", "1 5 bad_header\n"},
      {"RK1 me%4 1 -", "1 5 bad_header\n"},
      {"RK1 me%C3 1 -", "1 5 bad_header\n"},
      {"RK1 me -1 -", "1 8 bad_header\n"},
      {"RK1 me 0x1 -", "1 8 bad_header\n"},
      {"RK1 me 18446744073709551616 -", "1 8 bad_header\n"},
      {"RK1 me 1 -1", "1 10 bad_header\n"},
      {"RK1 me 1 1.", "1 10 bad_header\n"},
      {"RK1 me 1 .5", "1 10 bad_header\n"},
      {"RK1 me 1 1e3", "1 10 bad_header\n"},
      {"RK1 me 1 1.0000000001", "1 10 bad_header\n"},
      {"RK1 me 1 9223372036.854775808", "1 10 bad_header\n"},
      {"RK1 me 1 - part=1/2", "1 12 bad_header\n"},
      {"RK1 me 1 - part=a:0/2", "1 12 bad_header\n"},
      {"RK1 me 1 - part=a:3/2", "1 12 bad_header\n"},
      {"RK1 me 1 - part=a:1/65537", "1 12 bad_header\n"},
      {"RK1 me 1 - part=a:1/2 part=a:1/2", "1 23 bad_header\n"},
      {"RK1 me 1 - part", "1 12 bad_header\n"},
      {"RK1 me 1 - by=", "1 12 bad_header\n"},
      {"RK1 me 1 - via=r", "1 12 bad_header\n"},
      {"RK1 me 1 - via=r:-1", "1 12 bad_header\n"},
      {"RK1 me 1 - reset=1", "1 12 bad_header\n"},
      {"RK1 me 1 - restated restated", "1 21 bad_header\n"},
  };
  for (const auto& c : kCases) {
    SCOPED_TRACE(c.text);
    EXPECT_EQ(read(c.text), nullptr);
    EXPECT_EQ(faultsOf(std::string(c.text) + "\nremove arm\n"), c.faults);
    EXPECT_EQ(encodingOf(bytesOf(c.text)), "rk1");
  }
}

TEST_F(PacketHeaderText, TimesAreExactToTheNanosecond) {
  EXPECT_EQ(read("RK1 me 1 9223372036.854775807")->time_ns, INT64_MAX);
  EXPECT_EQ(read("RK1 me 1 0")->time_ns, 0);
  EXPECT_EQ(read("RK1 me 1 0012.25")->time_ns, 12250000000);
}

TEST_F(PacketHeaderText, NamesMayBe255BytesLong) {
  const std::string longest(255, 'a');
  EXPECT_EQ(read("RK1 " + longest + " - -")->source, longest);
  EXPECT_EQ(read("RK1 " + longest + "a - -"), nullptr);
  std::string encoded;
  for (int i = 0; i < 255; ++i) encoded += "%20";
  EXPECT_EQ(read("RK1 " + encoded + " - -")->source, std::string(255, ' '));
  EXPECT_EQ(read("RK1 " + encoded + "a - -"), nullptr);
}

TEST_F(PacketHeaderText, IsWrittenAsItIsRead) {
  const char* const kTexts[] = {
      "RK1 me - -",
      "RK1 arm@7f3a 12 100.5",
      "RK1 m%C3%A9%2F 0 0.000000001 restated part=a:2/3 by=relay reset via=r:9",
  };
  for (const char* const text : kTexts) EXPECT_EQ(headerText(*read(text)), text);
}

TEST(MakeDecoder, KnowsPacketTextAlone) {
  const auto decoder = makeDecoder("rk1");
  ASSERT_NE(decoder, nullptr);
  EXPECT_EQ(decoder->encoding(), "rk1");
  EXPECT_EQ(makeDecoder("octets"), nullptr);
}

}  // namespace
}  // namespace rocinante
