#include <gmock/gmock.h>
#include <zstd.h>

#include <algorithm>

#include "core/base/hash.h"
#include "core/mcap/append_record.h"
#include "core/mcap/chunk_expander.h"
#include "core/mcap/record_stepper.h"
#include "core/mcap/records.h"
#include "tests/core/log/log_support.h"
#include "tests/support/next_place.h"

namespace rocinante::test {
namespace {

using ::testing::ElementsAreArray;
using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr std::size_t kMessages = 12;

/// A log that ends in a chunk, made by hand from docs/log-format.md: while the chunk is open, and
/// after its header was completed.
struct ChunkedLog {
  Bytes open, closed;
  std::size_t head = 0, head_bytes = 0;   ///< position and size of the chunk's header
  std::vector<std::size_t> message_ends;  ///< the shortest part of the file that holds message i
};

std::string payloadOf(std::size_t i) { return "RK1 arm@7f " + std::to_string(i) + " -\n"; }

/// One zstd frame without size and checksum, flushed after every message.
Bytes compressed(const Bytes& records, const std::vector<std::size_t>& ends,
                 std::vector<std::size_t>& stored_ends) {
  ZSTD_CCtx* const context = ZSTD_createCCtx();
  ZSTD_CCtx_setParameter(context, ZSTD_c_contentSizeFlag, 0);
  Bytes out(ZSTD_compressBound(records.size()) + 64 * ends.size());
  ZSTD_outBuffer to{out.data(), out.size(), 0};
  std::size_t done = 0;
  for (const std::size_t end : ends) {
    ZSTD_inBuffer from{records.data() + done, end - done, 0};
    EXPECT_EQ(ZSTD_compressStream2(context, &to, &from, ZSTD_e_flush), 0U);
    stored_ends.push_back(to.pos);
    done = end;
  }
  ZSTD_inBuffer from{nullptr, 0, 0};
  EXPECT_EQ(ZSTD_compressStream2(context, &to, &from, ZSTD_e_end), 0U);
  ZSTD_freeCCtx(context);
  out.resize(to.pos);
  return out;
}

ChunkedLog chunkedLog(bool zstd) {
  ChunkedLog log;
  log.open.assign(mcap::magic().begin(), mcap::magic().end());
  append(log.open, mcap::Header{"rocinante", "test"});
  append(log.open, mcap::Metadata{"rocinante.session", {{"format", "1"}, {"origin_ns", "1000"}}});
  Bytes records;
  append(records, mcap::Channel{0, 0, "/udp/1/arm", "rk1", {}});
  std::vector<std::size_t> ends;
  for (std::size_t i = 0; i < kMessages; ++i) {
    const std::string payload = payloadOf(i);
    append(records,
           mcap::Message{0, static_cast<std::uint32_t>(i), 1000 + i, 1000 + i, bytesOf(payload)});
    ends.push_back(records.size());
  }
  std::vector<std::size_t> stored_ends;
  const Bytes stored = zstd ? compressed(records, ends, stored_ends) : records;
  if (!zstd) stored_ends = ends;

  mcap::Chunk chunk{1000,           1000 + kMessages - 1, records.size(),
                    crc32(records), zstd ? "zstd" : "",   stored};
  log.head = log.open.size();
  log.head_bytes = 9 + 40 + chunk.compression.size();
  log.closed = log.open;
  append(log.closed, chunk);
  // The same with an open end.
  chunk.message_end_time = chunk.uncompressed_size = mcap::kOpenEnded;
  chunk.uncompressed_crc = 0;
  append(log.open, chunk);
  const std::byte ones{0xFF};
  std::fill_n(log.open.begin() + static_cast<std::ptrdiff_t>(log.head) + 1, 8, ones);
  std::fill_n(log.open.begin() + static_cast<std::ptrdiff_t>(log.head + log.head_bytes) - 8, 8,
              ones);
  for (const std::size_t end : stored_ends) {
    log.message_ends.push_back(log.head + log.head_bytes + end);
  }
  return log;
}

std::vector<std::string> firstPayloads(std::size_t count) {
  std::vector<std::string> payloads;
  for (std::size_t i = 0; i < count; ++i) payloads.push_back(payloadOf(i));
  return payloads;
}

bool tellsOfOpenChunk(const LogReader& reader) {
  return std::ranges::any_of(reader.damage(), [](const DamageSpan& damage) {
    return damage.cause.find("never finished") != std::string::npos;
  });
}

class ReadOpenChunk : public ::testing::TestWithParam<bool> {};

TEST_P(ReadOpenChunk, IsReadAndFoundByTime) {
  const ChunkedLog log = chunkedLog(GetParam());
  LogReader reader = openLog(log.open);
  EXPECT_EQ(reader.summary().messages, kMessages);
  EXPECT_EQ(reader.summary().origin, at(1000));
  EXPECT_EQ(reader.summary().end, at(1000 + kMessages - 1));
  EXPECT_FALSE(reader.summary().complete);
  EXPECT_THAT(payloads(reader), ElementsAreArray(firstPayloads(kMessages)));
  ASSERT_TRUE(reader.seek(at(1005)).ok());
  EXPECT_EQ(textOf((*reader.next())->payload), payloadOf(5));
  EXPECT_EQ(textOf((*reader.lastOf(0, at(1003)))->payload), payloadOf(3));
  EXPECT_EQ(reader.storage().chunks, 1U);
  EXPECT_LT(reader.storage().expanded_bytes, 2000U);
  ASSERT_THAT(reader.damage(), SizeIs(2));
  EXPECT_THAT(reader.damage()[0].cause, HasSubstr("never finished"));
  EXPECT_EQ(reader.damage()[0].from, log.head);
  EXPECT_EQ(reader.damage()[0].to, log.open.size());
  EXPECT_THAT(reader.damage()[1].cause, HasSubstr("never closed"));
}

TEST_P(ReadOpenChunk, CutAtEveryByteGivesBackEveryMessageFlushedBefore) {
  const ChunkedLog log = chunkedLog(GetParam());
  for (std::size_t size = 8; size <= log.open.size(); size += nextPlace()) {
    SCOPED_TRACE(size);
    const Bytes cut = cutAt(log.open, size);
    LogReader reader = openLog(cut);
    const auto whole = static_cast<std::size_t>(
        std::ranges::count_if(log.message_ends, [&](std::size_t end) { return end <= size; }));
    // A compressed block is either whole or missing.
    ASSERT_THAT(payloads(reader), ElementsAreArray(firstPayloads(whole)));
    EXPECT_EQ(reader.summary().messages, whole);
  }
}

/// The header is completed in one write, which a power cut may tear at any byte, from either side.
TEST_P(ReadOpenChunk, ATornHeaderLosesNothing) {
  const ChunkedLog log = chunkedLog(GetParam());
  for (std::size_t torn = 0; torn <= log.head_bytes; ++torn) {
    for (const bool front_is_new : {true, false}) {
      SCOPED_TRACE(::testing::Message() << torn << " bytes of it " << front_is_new);
      Bytes file = front_is_new ? log.open : log.closed;
      const Bytes& front = front_is_new ? log.closed : log.open;
      std::copy_n(front.begin() + static_cast<std::ptrdiff_t>(log.head), torn,
                  file.begin() + static_cast<std::ptrdiff_t>(log.head));
      LogReader reader = openLog(file);
      ASSERT_THAT(payloads(reader), ElementsAreArray(firstPayloads(kMessages)));
      EXPECT_TRUE(file == log.closed || reader.damage().size() > 1);
    }
  }
}

TEST_P(ReadOpenChunk, WhatFollowsItIsReadToo) {
  const ChunkedLog log = chunkedLog(GetParam());
  Bytes file = log.open;
  append(file, mcap::Metadata{"note", {{"a", "b"}}});
  append(file, mcap::DataEnd{});
  append(file, mcap::Footer{});
  file.insert(file.end(), mcap::magic().begin(), mcap::magic().end());
  LogReader reader = openLog(file);
  EXPECT_THAT(payloads(reader), ElementsAreArray(firstPayloads(kMessages)));
  ASSERT_THAT(reader.metadata(), SizeIs(2));
  EXPECT_EQ(reader.metadata()[1].name, "note");
  EXPECT_TRUE(tellsOfOpenChunk(reader));
  ASSERT_THAT(reader.damage(), SizeIs(1));
}

TEST_P(ReadOpenChunk, ZerosOfASpaceThatWasAllocatedAheadAreNoMessages) {
  const ChunkedLog log = chunkedLog(GetParam());
  for (const std::size_t size : {log.message_ends[5], log.open.size()}) {
    SCOPED_TRACE(size);
    Bytes file = cutAt(log.open, size);
    file.resize(file.size() + 5000);
    LogReader reader = openLog(file);
    ASSERT_THAT(payloads(reader),
                ElementsAreArray(firstPayloads(size == log.open.size() ? kMessages : 6)));
    EXPECT_TRUE(tellsOfOpenChunk(reader));
  }
}

TEST_P(ReadOpenChunk, IsFoundBehindDamage) {
  const ChunkedLog log = chunkedLog(GetParam());
  for (std::size_t byte = 8; byte < log.head; ++byte) {
    SCOPED_TRACE(byte);
    Bytes file = log.open;
    file[byte] ^= std::byte{0x80};
    LogReader reader = openLog(file);
    ASSERT_THAT(payloads(reader), ElementsAreArray(firstPayloads(kMessages)));
  }
}

TEST_P(ReadOpenChunk, AFlippedBitNeverChangesAPayloadSilently) {
  const ChunkedLog log = chunkedLog(GetParam());
  for (std::size_t byte = 8; byte < log.open.size(); byte += nextPlace()) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      SCOPED_TRACE(::testing::Message() << "byte " << byte << " bit " << bit);
      Bytes file = log.open;
      file[byte] ^= static_cast<std::byte>(1U << bit);
      LogReader reader = openLog(file);
      const std::vector<std::string> read = payloads(reader);
      // No checksum covers an open chunk, so damage there is always reported.
      ASSERT_TRUE(std::ranges::any_of(reader.damage(),
                                      [&](const DamageSpan& damage) {
                                        return damage.from <= byte &&
                                               (byte < damage.to || damage.to > log.head);
                                      }) ||
                  read == firstPayloads(kMessages));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Compression, ReadOpenChunk, ::testing::Bool(),
                         [](const auto& each) { return each.param ? "zstd" : "none"; });

/// A small open chunk that would expand without limit.
TEST(OpenChunkBomb, IsExpandedOnlyUpToTheLimit) {
  const Bytes zeros(std::size_t{300} << 20U);
  Bytes frame(ZSTD_compressBound(zeros.size()));
  ZSTD_CCtx* const context = ZSTD_createCCtx();
  ZSTD_CCtx_setParameter(context, ZSTD_c_contentSizeFlag, 0);
  frame.resize(ZSTD_compress2(context, frame.data(), frame.size(), zeros.data(), zeros.size()));
  ZSTD_freeCCtx(context);
  mcap::Chunk chunk{1, 2, mcap::kOpenEnded, 0, "zstd", frame};
  mcap::ChunkExpander expander;
  mcap::Scratch scratch;
  const Result<ByteView> records = expander.expandCut(chunk, scratch);
  ASSERT_TRUE(records.ok());
  EXPECT_EQ(records->size(), mcap::kMaxChunkBytes);
}

}  // namespace
}  // namespace rocinante::test
