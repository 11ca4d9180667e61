#include <gmock/gmock.h>

#include <algorithm>

#include "core/mcap/byte_sink.h"
#include "tests/core/log/log_support.h"
#include "tests/support/next_place.h"

namespace rocinante::test {
namespace {

using ::testing::ElementsAreArray;
using ::testing::IsEmpty;
using ::testing::Not;

/// One write of a recorder: an append, an overwrite or a truncation.
struct Write {
  std::uint64_t offset = 0;
  Bytes bytes;
  bool truncates = false;
};

class NotingSink final : public ByteSink {
 public:
  explicit NotingSink(std::vector<Write>& writes) : writes_(writes) {}

  Status append(ByteView bytes) override {
    writes_.push_back({size_, Bytes(bytes.begin(), bytes.end()), false});
    size_ += bytes.size();
    return {};
  }
  Status truncate(std::uint64_t size_bytes) override {
    writes_.push_back({size_bytes, {}, true});
    size_ = size_bytes;
    return {};
  }
  bool overwritable() const override { return true; }
  Status overwriteAt(std::uint64_t offset, ByteView bytes) override {
    writes_.push_back({offset, Bytes(bytes.begin(), bytes.end()), false});
    return {};
  }
  Status close() override { return {}; }
  const std::string& name() const override { return name_; }

 private:
  std::vector<Write>& writes_;
  std::uint64_t size_ = 0;
  std::string name_ = "noted";
};

/// Applies the first `count` bytes of a write to the file.
void apply(Bytes& file, const Write& write, std::size_t count) {
  const auto offset = static_cast<std::size_t>(write.offset);
  if (write.truncates) return file.resize(offset);
  file.resize(std::max(file.size(), offset + count));
  std::copy_n(write.bytes.begin(), count, file.begin() + static_cast<std::ptrdiff_t>(offset));
}

struct Recording {
  std::vector<Write> writes;
  std::vector<KeptMessage> messages;
  std::vector<std::size_t> flushed;  ///< messages that must be in the file after write i
};

/// Chunks that fill up at once, chunks that stay open over several flushes, with a metadata record
/// and an attachment between them.
Recording record(LogWriterOptions::Compression compression) {
  Recording out;
  LogWriterOptions options;
  options.compression = compression;
  options.chunk_bytes = 1500;
  Result<LogWriter> writer =
      LogWriter::createOn(std::make_unique<NotingSink>(out.writes), options, "session-1");
  EXPECT_TRUE(writer.ok());
  const auto noteFlushed = [&](std::size_t messages) {
    const std::size_t before = out.flushed.empty() ? 0 : out.flushed.back();
    // The messages of a flush are in the file after its last write.
    out.flushed.resize(out.writes.size(), before);
    if (!out.flushed.empty()) out.flushed.back() = messages;
  };
  const ChannelId a = *writer->addChannel("/udp/1/arm", "rk1", {{"source", "arm"}});
  const ChannelId b = *writer->addChannel("/udp/1/tool", "octets", {});
  SteadyTime now{};
  for (int i = 0; i < 48; ++i) {
    const std::string payload = "RK1 arm@7f " + std::to_string(i) + " -\njoints arm " +
                                std::to_string(i * 7919 % 1000) + " 0.25 -1.5";
    const bool other = i % 5 == 4;
    EXPECT_TRUE(writer
                    ->write(other ? b : a, static_cast<std::uint32_t>(i), at(1000 + i / 2), 7,
                            bytesOf(payload))
                    .ok());
    out.messages.push_back({other ? "/udp/1/tool" : "/udp/1/arm", static_cast<std::uint32_t>(i),
                            1000 + i / 2, 7, payload});
    if (i == 20) {
      EXPECT_TRUE(writer->writeAttachment("cell.toml", "text/plain", at(1), bytesOf("abc")).ok());
    }
    now += options.sync;
    // Slow, fast and slow again: open chunks, then full ones, then open ones.
    if (i % 3 == 2 && (i < 16 || i > 34)) {
      EXPECT_TRUE(writer->flushIfDue(now).ok());
      noteFlushed(out.messages.size());
    }
  }
  EXPECT_TRUE(writer->close("finished").ok());
  noteFlushed(out.messages.size());
  return out;
}

class KilledLog : public ::testing::TestWithParam<LogWriterOptions::Compression> {};

TEST_P(KilledLog, AtEveryByteOfEveryWriteGivesBackWhatWasFlushedInBothDirections) {
  const Recording recording = record(GetParam());
  Bytes file;
  std::size_t safe = 0;
  std::size_t open_chunks = 0;
  for (std::size_t i = 0; i < recording.writes.size(); ++i) {
    const Write& write = recording.writes[i];
    for (std::size_t count = 0; count < std::max<std::size_t>(write.bytes.size(), 1);
         count += nextPlace()) {
      SCOPED_TRACE(::testing::Message() << "write " << i << " byte " << count);
      Bytes now = file;
      apply(now, write, count);
      now.shrink_to_fit();
      if (now.size() < 8) continue;
      LogReader reader = openLog(now);
      const std::vector<KeptMessage> read = readAll(reader);
      ASSERT_GE(read.size(), safe);
      ASSERT_LE(read.size(), recording.messages.size());
      const auto end = recording.messages.begin() + static_cast<std::ptrdiff_t>(read.size());
      ASSERT_THAT(read, ElementsAreArray(recording.messages.begin(), end));
      ASSERT_EQ(reader.summary().messages, read.size());
      ASSERT_THAT(reader.damage(), Not(IsEmpty()));
      for (std::size_t back = read.size(); back-- > 0;) {
        const std::optional<LogMessage> message = *reader.previous();
        ASSERT_TRUE(message && keep(*message) == read[back]);
      }
      ASSERT_FALSE(reader.previous()->has_value());
      if (!read.empty()) {
        ASSERT_TRUE(reader.seek(at(read.back().log_time_ns)).ok());
        ASSERT_EQ((*reader.next())->log_time, at(read.back().log_time_ns));
      }
      open_chunks += std::ranges::any_of(reader.damage(), [](const DamageSpan& damage) {
        return damage.cause.find("never finished") != std::string::npos;
      });
    }
    apply(file, write, write.bytes.size());
    safe = std::max(safe, recording.flushed[i]);
  }
  LogReader reader = openLog(file);
  EXPECT_THAT(readAll(reader), ElementsAreArray(recording.messages));
  EXPECT_THAT(reader.damage(), IsEmpty());
  EXPECT_GT(open_chunks, 100U / nextPlace());
}

INSTANTIATE_TEST_SUITE_P(Compression, KilledLog,
                         ::testing::Values(LogWriterOptions::Compression::none,
                                           LogWriterOptions::Compression::zstd),
                         [](const auto& each) {
                           return each.param == LogWriterOptions::Compression::none ? "none"
                                                                                    : "zstd";
                         });

}  // namespace
}  // namespace rocinante::test
