#include "core/mcap/records.h"

#include <gmock/gmock.h>

#include <functional>

#include "core/base/hash.h"
#include "core/mcap/append_record.h"
#include "core/mcap/parse_record.h"

namespace rocinante::mcap {
namespace {

using ::testing::ElementsAreArray;

/// Bytes written by hand, field by field.
class Hand {
 public:
  Hand& u8(std::uint64_t value) { return put(value, 1); }
  Hand& u16(std::uint64_t value) { return put(value, 2); }
  Hand& u32(std::uint64_t value) { return put(value, 4); }
  Hand& u64(std::uint64_t value) { return put(value, 8); }
  Hand& text(std::string_view value) {
    for (const char c : value) bytes_.push_back(static_cast<std::byte>(c));
    return *this;
  }
  operator const Bytes&() const { return bytes_; }  // NOLINT: so that it can be compared as it is
  const Bytes& bytes() const { return bytes_; }

 private:
  Hand& put(std::uint64_t value, int count) {
    for (int i = 0; i < count; ++i) {
      bytes_.push_back(static_cast<std::byte>(value & 0xFFU));
      value >>= 8U;
    }
    return *this;
  }
  Bytes bytes_;
};

/// The record is written as exactly `expected`; those bytes, read and appended again, are the same;
/// no shorter content is accepted as whole, and a longer one only if the format lets the record
/// grow.
template <class T>
void expectBytes(const T& record, const Bytes& expected, bool may_grow) {
  Bytes made;
  append(made, record);
  ASSERT_THAT(made, ElementsAreArray(expected));
  const ByteView content = ByteView(expected).subspan(kPrefixBytes);
  T read;
  const std::optional<std::size_t> used = parse(content, read);
  ASSERT_TRUE(used.has_value());
  EXPECT_EQ(*used, content.size());
  Bytes again;
  append(again, read);
  EXPECT_THAT(again, ElementsAreArray(expected));
  if constexpr (!std::is_same_v<T, Message>) {  // its data is all that is left
    for (std::size_t size = 0; size < content.size(); ++size) {
      const Bytes cut(content.begin(), content.begin() + static_cast<std::ptrdiff_t>(size));
      T ignored;
      EXPECT_FALSE(parse(cut, ignored).has_value()) << "cut at " << size;
    }
    Bytes grown(content.begin(), content.end());
    grown.push_back(std::byte{0});
    T ignored;
    EXPECT_EQ(parse(grown, ignored).has_value(), may_grow);
  }
}

TEST(McapRecords, Header) {
  expectBytes(Header{"rocinante", "lib"},
              Hand()
                  .u8(0x01)            // opcode
                  .u64(4 + 9 + 4 + 3)  // length
                  .u32(9)
                  .text("rocinante")  // profile
                  .u32(3)
                  .text("lib"),  // library
              true);
}

TEST(McapRecords, Footer) {
  expectBytes(Footer{0x1122334455667788, 7, 0xAABBCCDD},
              Hand()
                  .u8(0x02)                 // opcode
                  .u64(20)                  // length
                  .u64(0x1122334455667788)  // summary start
                  .u64(7)                   // summary offset start
                  .u32(0xAABBCCDD),         // summary CRC
              false);
}

TEST(McapRecords, Schema) {
  expectBytes(Schema{3, "n", "enc", {std::byte{9}, std::byte{8}}},
              Hand()
                  .u8(0x03)                        // opcode
                  .u64(2 + 4 + 1 + 4 + 3 + 4 + 2)  // length
                  .u16(3)                          // id
                  .u32(1)
                  .text("n")  // name
                  .u32(3)
                  .text("enc")  // encoding
                  .u32(2)
                  .u8(9)
                  .u8(8),  // data
              true);
}

TEST(McapRecords, Channel) {
  expectBytes(Channel{0x0102, 0, "/udp/1/a", "rk1", {{"k", "v"}, {"local", ""}}},
              Hand()
                  .u8(0x04)                             // opcode
                  .u64(2 + 2 + 4 + 8 + 4 + 3 + 4 + 23)  // length
                  .u16(0x0102)                          // id
                  .u16(0)                               // schema id: none
                  .u32(8)
                  .text("/udp/1/a")  // topic
                  .u32(3)
                  .text("rk1")  // message encoding
                  .u32(23)      // metadata, in bytes
                  .u32(1)
                  .text("k")
                  .u32(1)
                  .text("v")  // first pair
                  .u32(5)
                  .text("local")
                  .u32(0),  // second pair
              true);
}

TEST(McapRecords, Message) {
  const std::string data = "RK1";
  expectBytes(Message{2, 5, 1000, 998, bytesOf(data)},
              Hand()
                  .u8(0x05)      // opcode
                  .u64(22 + 3)   // length
                  .u16(2)        // channel id
                  .u32(5)        // sequence
                  .u64(1000)     // log time
                  .u64(998)      // publish time
                  .text("RK1"),  // data, the rest
              true);
  struct Message ignored;
  const Bytes short_by_one(21);
  EXPECT_FALSE(parse(short_by_one, ignored).has_value());
}

TEST(McapRecords, Chunk) {
  const std::string records = "abcd";
  expectBytes(Chunk{10, 20, 99, 0x01020304, "zstd", bytesOf(records)},
              Hand()
                  .u8(0x06)                            // opcode
                  .u64(8 + 8 + 8 + 4 + 4 + 4 + 8 + 4)  // length
                  .u64(10)                             // message start time
                  .u64(20)                             // message end time
                  .u64(99)                             // uncompressed size
                  .u32(0x01020304)                     // uncompressed CRC
                  .u32(4)
                  .text("zstd")  // compression
                  .u64(4)
                  .text("abcd"),  // records
              true);
}

TEST(McapRecords, MessageIndex) {
  expectBytes(MessageIndex{7, {{100, 0}, {90, 131}}},
              Hand()
                  .u8(0x07)         // opcode
                  .u64(2 + 4 + 32)  // length
                  .u16(7)           // channel id
                  .u32(32)          // records, in bytes
                  .u64(100)
                  .u64(0)  // log time, offset
                  .u64(90)
                  .u64(131),  // in order of writing, not of time
              true);
}

TEST(McapRecords, ChunkIndex) {
  expectBytes(ChunkIndex{10, 20, 30, 40, {{1, 70}, {2, 80}}, 50, "zstd", 60, 99},
              Hand()
                  .u8(0x08)                                 // opcode
                  .u64(8 * 4 + 4 + 20 + 8 + 4 + 4 + 8 + 8)  // length
                  .u64(10)                                  // message start time
                  .u64(20)                                  // message end time
                  .u64(30)                                  // chunk start offset
                  .u64(40)                                  // chunk length
                  .u32(20)                                  // message index offsets, in bytes
                  .u16(1)
                  .u64(70)  // channel, offset
                  .u16(2)
                  .u64(80)  //
                  .u64(50)  // message index length
                  .u32(4)
                  .text("zstd")  // compression
                  .u64(60)       // compressed size
                  .u64(99),      // uncompressed size
              true);
}

TEST(McapRecords, Attachment) {
  const std::string data = "xy";
  Hand content;
  content
      .u64(5)  // log time
      .u64(6)  // create time
      .u32(1)
      .text("n")  // name
      .u32(3)
      .text("a/b")  // media type
      .u64(2)
      .text("xy");  // data
  Hand expected;
  expected
      .u8(0x09)  // opcode
      .u64(8 + 8 + 5 + 7 + 10 + 4)
      .u64(5)
      .u64(6)
      .u32(1)
      .text("n")
      .u32(3)
      .text("a/b")
      .u64(2)
      .text("xy")
      .u32(crc32(content.bytes()));  // CRC of everything before it in the content
  Attachment attachment;
  attachment.log_time = 5;
  attachment.create_time = 6;
  attachment.name = "n";
  attachment.media_type = "a/b";
  attachment.data = bytesOf(data);
  expectBytes(attachment, expected, true);
  Attachment read;
  ASSERT_TRUE(parse(ByteView(expected.bytes()).subspan(kPrefixBytes), read));
  EXPECT_EQ(read.crc, crc32(read.checked));
}

TEST(McapRecords, AttachmentIndex) {
  expectBytes(AttachmentIndex{1, 2, 3, 4, 5, "n", "a/b"},
              Hand()
                  .u8(0x0A)                    // opcode
                  .u64(8 * 5 + 4 + 1 + 4 + 3)  // length
                  .u64(1)                      // offset
                  .u64(2)                      // length of the attachment
                  .u64(3)                      // log time
                  .u64(4)                      // create time
                  .u64(5)                      // data size
                  .u32(1)
                  .text("n")  // name
                  .u32(3)
                  .text("a/b"),  // media type
              true);
}

TEST(McapRecords, Statistics) {
  expectBytes(Statistics{1, 2, 3, 4, 5, 6, 7, 8, {{9, 1}}},
              Hand()
                  .u8(0x0B)                                     // opcode
                  .u64(8 + 2 + 4 + 4 + 4 + 4 + 8 + 8 + 4 + 10)  // length
                  .u64(1)                                       // message count
                  .u16(2)                                       // schema count
                  .u32(3)                                       // channel count
                  .u32(4)                                       // attachment count
                  .u32(5)                                       // metadata count
                  .u32(6)                                       // chunk count
                  .u64(7)                                       // message start time
                  .u64(8)                                       // message end time
                  .u32(10)                                      // counts, in bytes
                  .u16(9)
                  .u64(1),  // channel, count
              true);
}

TEST(McapRecords, Metadata) {
  expectBytes(Metadata{"rocinante.end", {{"reason", "signal"}}},
              Hand()
                  .u8(0x0C)              // opcode
                  .u64(4 + 13 + 4 + 20)  // length
                  .u32(13)
                  .text("rocinante.end")  // name
                  .u32(20)                // map, in bytes
                  .u32(6)
                  .text("reason")
                  .u32(6)
                  .text("signal"),
              true);
}

TEST(McapRecords, MetadataIndex) {
  expectBytes(MetadataIndex{1, 2, "n"},
              Hand()
                  .u8(0x0D)            // opcode
                  .u64(8 + 8 + 4 + 1)  // length
                  .u64(1)              // offset
                  .u64(2)              // length of the metadata
                  .u32(1)
                  .text("n"),  // name
              true);
}

TEST(McapRecords, SummaryOffset) {
  expectBytes(SummaryOffset{Opcode::statistics, 1, 2},
              Hand()
                  .u8(0x0E)  // opcode
                  .u64(17)   // length
                  .u8(0x0B)  // the group's opcode
                  .u64(1)    // group start
                  .u64(2),   // group length
              true);
}

TEST(McapRecords, DataEnd) {
  expectBytes(DataEnd{0xDEADBEEF},
              Hand()
                  .u8(0x0F)          // opcode
                  .u64(4)            // length
                  .u32(0xDEADBEEF),  // data section CRC
              false);
}

TEST(McapRecords, AMapWhosePairsDoNotFillItIsRefused) {
  const Hand content = Hand()
                           .u32(1)
                           .text("n")  // name
                           .u32(9)     // one byte more than the pair takes
                           .u32(0)
                           .u32(0)
                           .u8(0);  // a pair of empty strings, and a byte
  Metadata ignored;
  EXPECT_FALSE(parse(content.bytes(), ignored).has_value());
}

TEST(McapRecords, AMessageIndexOfHalfARecordIsRefused) {
  const Hand content = Hand().u16(1).u32(17).u64(1).u64(2).u8(0);
  MessageIndex ignored;
  EXPECT_FALSE(parse(content.bytes(), ignored).has_value());
}

TEST(McapRecords, ALengthBeyondTheEndAllocatesNothing) {
  const Hand content = Hand().u16(1).u32(0xFFFFFFFF);
  MessageIndex ignored;
  EXPECT_FALSE(parse(content.bytes(), ignored).has_value());
}

}  // namespace
}  // namespace rocinante::mcap
