#include "core/mcap/open_chunk.h"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>
#include <zstd.h>

#include <algorithm>

#include "core/base/hash.h"
#include "core/mcap/byte_cursor.h"
#include "core/mcap/parse_record.h"
#include "core/mcap/writer.h"
#include "tests/core/log/log_support.h"
#include "tests/support/stream_reader.h"

namespace rocinante::test {
namespace {

using mcap::appendNumber;
using mcap::Opcode;

constexpr std::uint64_t kOpen = ~std::uint64_t{0};

/// An MCAP file written message by message, all on channel 3.
struct Writing {
  explicit Writing(std::optional<int> zstd_level) {
    mcap::WriterOptions options;
    options.zstd_level = zstd_level;
    writer.emplace(std::move(*mcap::Writer::start(makeMemorySink(file), options, {"p", "l"})));
    writer->addChannel({3, 0, "/t", "e", {}});
    opening = file;
  }
  void write(std::uint64_t log_time, std::string_view payload) {
    ASSERT_TRUE(writer->write({3, sequence++, log_time, log_time, bytesOf(payload)}).ok());
  }

  Bytes file;
  Bytes opening;  ///< magic and Header
  std::optional<mcap::Writer> writer;
  std::uint32_t sequence = 0;
};

/// The Channel record of Writing, field by field.
void putChannel(Bytes& out) {
  out.push_back(std::byte{0x04});
  appendNumber<std::uint64_t>(out, 2 + 2 + (4 + 2) + (4 + 1) + 4);
  appendNumber<std::uint16_t>(out, 3);  // id
  appendNumber<std::uint16_t>(out, 0);  // no schema
  mcap::appendString(out, "/t");
  mcap::appendString(out, "e");
  appendNumber<std::uint32_t>(out, 0);  // no metadata
}

void putMessage(Bytes& out, std::uint32_t sequence, std::uint64_t log_time,
                std::string_view payload) {
  out.push_back(std::byte{0x05});
  appendNumber<std::uint64_t>(out, 22 + payload.size());
  appendNumber<std::uint16_t>(out, 3);
  appendNumber(out, sequence);
  appendNumber(out, log_time);
  appendNumber(out, log_time);  // publish_time
  mcap::appendBytes(out, bytesOf(payload));
}

void putChunkHeader(Bytes& out, std::uint64_t length, std::uint64_t start, std::uint64_t end,
                    std::uint64_t uncompressed_bytes, std::uint32_t crc,
                    std::string_view compression, std::uint64_t records_bytes) {
  out.push_back(std::byte{0x06});
  appendNumber(out, length);
  appendNumber(out, start);
  appendNumber(out, end);
  appendNumber(out, uncompressed_bytes);
  appendNumber(out, crc);
  mcap::appendString(out, compression);
  appendNumber(out, records_bytes);
}

TEST(OpenChunk, PlainStandsInTheFileByteForByteAtEachStage) {
  Writing log(std::nullopt);
  log.write(70, "one");
  log.write(60, "two");
  EXPECT_EQ(log.file, log.opening) << "in memory until it is flushed";

  ASSERT_TRUE(log.writer->flush().ok());
  Bytes records;
  putChannel(records);
  const std::uint64_t first_offset = records.size();
  putMessage(records, 0, 70, "one");
  const std::uint64_t second_offset = records.size();
  putMessage(records, 1, 60, "two");
  Bytes begun = log.opening;
  putChunkHeader(begun, kOpen, 60, kOpen, kOpen, 0, "", kOpen);
  mcap::appendBytes(begun, records);
  EXPECT_EQ(log.file, begun);

  log.write(80, "three");
  EXPECT_EQ(log.file, begun);
  ASSERT_TRUE(log.writer->flush().ok());
  const std::uint64_t third_offset = records.size();
  putMessage(records, 2, 80, "three");
  Bytes added = begun;
  putMessage(added, 2, 80, "three");
  EXPECT_EQ(log.file, added);
  ASSERT_TRUE(log.writer->flush().ok());
  EXPECT_EQ(log.file, added) << "nothing waits, so nothing is written";

  ASSERT_TRUE(log.writer->closeChunk().ok());
  Bytes closed = log.opening;
  putChunkHeader(closed, 40 + records.size(), 60, 80, records.size(), crc32(records), "",
                 records.size());
  mcap::appendBytes(closed, records);
  closed.push_back(std::byte{0x07});  // MessageIndex
  appendNumber<std::uint64_t>(closed, 2 + 4 + 3 * 16);
  appendNumber<std::uint16_t>(closed, 3);
  appendNumber<std::uint32_t>(closed, 3 * 16);
  for (const auto& [log_time, offset] :
       {std::pair{70UL, first_offset}, {60UL, second_offset}, {80UL, third_offset}}) {
    appendNumber<std::uint64_t>(closed, log_time);
    appendNumber<std::uint64_t>(closed, offset);
  }
  EXPECT_EQ(log.file, closed);

  const std::uint32_t data_crc = crc32(log.file);
  ASSERT_TRUE(log.writer->finish().ok());
  Bytes data_end{std::byte{0x0F}};
  appendNumber<std::uint64_t>(data_end, 4);
  appendNumber(data_end, data_crc);
  ASSERT_GT(log.file.size(), closed.size() + data_end.size());
  EXPECT_EQ(cutAt(log.file, closed.size()), closed);
  EXPECT_TRUE(std::equal(data_end.begin(), data_end.end(),
                         log.file.begin() + static_cast<std::ptrdiff_t>(closed.size())));
}

/// The output of a zstd decoder for the bytes so far, and whether the frame has ended.
std::pair<Bytes, bool> expand(ByteView frame) {
  Bytes out(1U << 16U);
  ZSTD_DCtx* const zstd = ZSTD_createDCtx();
  ZSTD_inBuffer in{frame.data(), frame.size(), 0};
  ZSTD_outBuffer made{out.data(), out.size(), 0};
  std::size_t hint = 1;
  while (in.pos < in.size && hint != 0) {
    hint = ZSTD_decompressStream(zstd, &made, &in);
    if (ZSTD_isError(hint) != 0U) {
      ADD_FAILURE() << ZSTD_getErrorName(hint);
      break;
    }
  }
  EXPECT_EQ(in.pos, in.size) << "bytes behind the frame";
  ZSTD_freeDCtx(zstd);
  out.resize(made.pos);
  return {out, hint == 0};
}

TEST(OpenChunk, CompressedCanBeExpandedUpToItsLastFlush) {
  Writing log(1);
  Bytes records;
  putChannel(records);
  Bytes header;
  putChunkHeader(header, kOpen, 100, kOpen, kOpen, 0, "zstd", kOpen);
  const std::size_t start = log.opening.size() + header.size();
  for (std::uint32_t i = 0; i < 20; ++i) {
    const std::string payload = "payload " + std::to_string(i);
    log.write(100 + i, payload);
    putMessage(records, i, 100 + i, payload);
    ASSERT_TRUE(log.writer->flush().ok());
    EXPECT_TRUE(std::equal(header.begin(), header.end(),
                           log.file.begin() + static_cast<std::ptrdiff_t>(log.opening.size())));
    const auto [expanded, ended] = expand(ByteView(log.file).subspan(start));
    EXPECT_EQ(expanded, records);
    EXPECT_FALSE(ended);
  }
  const std::size_t flushed = log.file.size();
  ASSERT_TRUE(log.writer->closeChunk().ok());
  // Nothing was unflushed, so the frame's end is an empty last block.
  EXPECT_EQ(log.file[flushed], std::byte{1});
  EXPECT_EQ(log.file[flushed + 1], std::byte{0});
  EXPECT_EQ(log.file[flushed + 2], std::byte{0});
  const std::uint64_t stored = flushed + 3 - start;
  Bytes whole;
  putChunkHeader(whole, 44 + stored, 100, 119, records.size(), crc32(records), "zstd", stored);
  EXPECT_TRUE(std::equal(whole.begin(), whole.end(),
                         log.file.begin() + static_cast<std::ptrdiff_t>(log.opening.size())));
  const auto [expanded, ended] = expand(ByteView(log.file).subspan(start, stored));
  EXPECT_EQ(expanded, records);
  EXPECT_TRUE(ended);
  ASSERT_TRUE(log.writer->finish().ok());
}

TEST(OpenChunk, ThatIsNeverFlushedIsWrittenInOnePiece) {
  Writing log(1);
  std::string noise;
  for (int i = 0; i < 3000; ++i) noise += static_cast<char>('a' + i * i % 23);
  log.write(1, noise);
  ASSERT_TRUE(log.writer->closeChunk().ok());
  mcap::Chunk chunk;
  const auto record = mcap::recordAt(log.file, log.opening.size());
  ASSERT_TRUE(record && mcap::parse(record->content, chunk));
  EXPECT_EQ(chunk.compression, "zstd");
  EXPECT_EQ(ZSTD_getFrameContentSize(chunk.records.data(), chunk.records.size()),
            chunk.uncompressed_size);
}

/// A sink that can only grow, like a pipe.
class PipeSink final : public ByteSink {
 public:
  explicit PipeSink(Bytes& out) : out_(out) {}
  Status append(ByteView bytes) override {
    mcap::appendBytes(out_, bytes);
    return {};
  }
  Status truncate(std::uint64_t) override { return Error{ErrorKind::refused, "a pipe", {}}; }
  Status close() override { return {}; }
  const std::string& name() const override { return name_; }

 private:
  Bytes& out_;
  std::string name_ = "pipe";
};

TEST(OpenChunk, IsClosedAtEachFlushWhereTheFileCanOnlyGrow) {
  Bytes file;
  LogWriter writer = *LogWriter::createOn(std::make_unique<PipeSink>(file), {}, "s");
  const ChannelId channel = *writer.addChannel("/udp/1/a", "octets", {});
  SteadyTime now{};
  for (std::uint32_t i = 0; i < 5; ++i) {
    ASSERT_TRUE(writer.write(channel, i, at(i), 0, bytesOf("x")).ok());
    now += std::chrono::seconds(1);
    ASSERT_TRUE(writer.flushIfDue(now).ok());
    const Bytes copy = cutAt(file, file.size());
    LogReader killed = openLog(copy);
    EXPECT_EQ(readAll(killed).size(), i + 1);
  }
  ASSERT_TRUE(writer.close("finished").ok());
  LogReader reader = openLog(file);
  EXPECT_EQ(readAll(reader).size(), 5U);
  EXPECT_TRUE(reader.summary().complete);
}

enum class Act { message, flush, metadata, attachment, close_chunk };

struct Step {
  Act act;
  int channel;
  std::int64_t time_ns;
  std::string payload;
};

rc::Gen<std::vector<Step>> steps() {
  return rc::gen::container<std::vector<Step>>(rc::gen::construct<Step>(
      rc::gen::weightedElement<Act>({{12, Act::message},
                                     {5, Act::flush},
                                     {1, Act::metadata},
                                     {1, Act::attachment},
                                     {1, Act::close_chunk}}),
      rc::gen::inRange(0, 4), rc::gen::cast<std::int64_t>(rc::gen::inRange(1, 60)),
      rc::gen::container<std::string>(rc::gen::arbitrary<char>())));
}

/// Reads the file strictly: its messages in file order. Chunk checksums and sizes are checked by
/// the reader, the data section's here.
std::vector<std::string> readStrictly(const Bytes& file) {
  std::vector<std::string> payloads;
  Result<test::StreamReader> reader = test::StreamReader::open(file);
  RC_ASSERT(reader.ok());
  while (true) {
    const Result<std::optional<mcap::Record>> record = reader->next();
    RC_ASSERT(record.ok());
    if (!*record) break;
    if ((*record)->opcode == Opcode::message) {
      mcap::Message message;
      RC_ASSERT(mcap::parse((*record)->content, message).has_value());
      payloads.emplace_back(textOf(message.data));
    } else if ((*record)->opcode == Opcode::data_end) {
      mcap::DataEnd end;
      RC_ASSERT(mcap::parse((*record)->content, end).has_value());
      const auto size = static_cast<std::size_t>((*record)->offset);
      RC_ASSERT(end.data_section_crc == crc32(ByteView(file).first(size)));
    }
  }
  return payloads;
}

RC_GTEST_PROP(OpenChunk, AnyMessagesWithAnyFlushesReadBackEqual, ()) {
  const std::vector<Step> written = *steps();
  mcap::WriterOptions options;
  options.chunk_bytes = static_cast<std::size_t>(*rc::gen::inRange(1, 2000));
  if (*rc::gen::arbitrary<bool>()) options.zstd_level.reset();
  Bytes file;
  mcap::Writer writer = *mcap::Writer::start(makeMemorySink(file), options, {"rocinante", "x"});
  for (std::uint16_t i = 0; i < 4; ++i) {
    writer.addChannel({i, 0, "/udp/" + std::to_string(i), "octets", {}});
  }
  std::vector<std::string> payloads;
  std::uint32_t sequence = 0;
  for (const Step& step : written) {
    const auto time = static_cast<std::uint64_t>(step.time_ns);
    switch (step.act) {
      case Act::message:
        payloads.push_back(step.payload);
        RC_ASSERT(writer
                      .write({static_cast<std::uint16_t>(step.channel), sequence++, time, time,
                              bytesOf(step.payload)})
                      .ok());
        break;
      case Act::flush: {
        RC_ASSERT(writer.flush().ok());
        // If the recorder is killed now, no message is missing.
        const Bytes copy = cutAt(file, file.size());
        LogReader killed = openLog(copy);
        RC_ASSERT(readAll(killed).size() == payloads.size());
        break;
      }
      case Act::metadata:
        RC_ASSERT(writer.writeMetadata({"m", {}}).ok());
        break;
      case Act::attachment: {
        mcap::Attachment attachment;
        attachment.data = bytesOf(step.payload);
        RC_ASSERT(writer.writeAttachment(attachment).ok());
        break;
      }
      case Act::close_chunk:
        RC_ASSERT(writer.closeChunk().ok());
        break;
    }
  }
  RC_ASSERT(writer.finish().ok());
  RC_ASSERT(writer.lost().empty());
  RC_ASSERT(readStrictly(file) == payloads);
  LogReader reader = openLog(file);
  RC_ASSERT(readAll(reader).size() == payloads.size());
  RC_ASSERT(reader.damage().empty());
}

}  // namespace
}  // namespace rocinante::test
