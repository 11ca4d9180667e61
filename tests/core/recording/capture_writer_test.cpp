#include "core/recording/capture_writer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "core/log/log_reader.h"
#include "recorder/pieces/piece_sequence.h"
#include "tests/core/recording/fake_clocks.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using test::logTime;

const SocketAddress kSender = SocketAddress::parse("10.0.0.1", 5000).value();

/// A sink with room for this many bytes, like a full disk.
class FullSink final : public ByteSink {
 public:
  FullSink(Bytes& out, std::size_t room) : out_(out), room_(room) {}
  Status append(ByteView bytes) override {
    if (bytes.size() > room_ - out_.size()) {
      return Error{ErrorKind::unreadable, "cannot write: No space left on device", name_};
    }
    out_.insert(out_.end(), bytes.begin(), bytes.end());
    return {};
  }
  Status truncate(std::uint64_t size_bytes) override {
    out_.resize(size_bytes);
    return {};
  }
  Status close() override { return {}; }
  const std::string& name() const override { return name_; }

 private:
  Bytes& out_;
  std::size_t room_;
  std::string name_ = "full";
};

struct Seen {
  std::string topic;
  std::uint32_t sequence;
  LogTime log_time;
  std::int64_t publish_time_ns;
  std::string payload;
};

struct Capturing {
  explicit Capturing(CaptureLimits limits = {}, std::size_t room = std::size_t{1} << 30) {
    LogWriterOptions options;
    options.chunk_bytes = 4'096;
    options.compression = LogWriterOptions::Compression::none;
    std::vector<ListenedEndpoint> endpoints;
    for (const std::string_view text : {"127.0.0.1:8", "127.0.0.1:9"}) {
      const Endpoint endpoint = Endpoint::parse(text).value();
      endpoints.push_back({endpoint, endpoint.address});
    }
    MadePiece made{
        LogWriter::createOn(std::make_unique<FullSink>(bytes, room), options, "session").value(),
        {}};
    writer.emplace(
        std::make_unique<PieceSequence>(std::move(made), PieceSequence::Options(), notes),
        endpoints, limits);
  }

  void arrive(std::uint32_t endpoint, LogTime time, std::string_view payload) {
    if (!taken.blocks.empty() &&
        taken.blocks.back()->add(endpoint, time, kSender, bytesOf(payload))) {
      return;
    }
    auto block = queue.freeBlock();
    ASSERT_TRUE(block);
    ASSERT_TRUE(block->add(endpoint, time, kSender, bytesOf(payload)));
    taken.blocks.push_back(std::move(block));
  }
  void write(LogTime drained_until) {
    taken.drained_until = drained_until;
    writer->write(std::exchange(taken, {}), queue);
  }
  void close() { writer->close("interrupted", queue); }

  LogReader reader() { return LogReader::openBytes(bytes, "memory").value(); }
  std::vector<Seen> messages() {
    LogReader log = reader();
    std::vector<Seen> seen;
    for (;;) {
      const auto message = log.next();
      if (!message || !*message) return seen;
      seen.push_back({(*message)->channel->topic, (*message)->sequence, (*message)->log_time,
                      (*message)->publish_time_ns, std::string(textOf((*message)->payload))});
    }
  }

  Bytes bytes;
  NoteBox notes;
  HandOver queue{64};
  TakenOver taken;
  std::optional<CaptureWriter> writer;
};

TEST(CaptureWriter, KeepsDatagramsVerbatimOnTheirChannels) {
  Capturing setup;
  const std::string hostile("\0\xff RK1\n\r\0", 9);
  setup.arrive(0, logTime(1ms), "RK1 arm@r1 7 12.5\njoints arm 1 2\n");
  setup.arrive(0, logTime(2ms), hostile);
  setup.arrive(1, logTime(3ms), "RK1 arm - -\n");
  setup.arrive(0, logTime(4ms), "RK1 arm@r1 8 12.6");
  setup.arrive(0, logTime(5ms), "RK1 arm@r1 8 12.6 restated by=relay part=1:1/1\n");
  setup.arrive(0, logTime(6ms), "");
  setup.write(logTime(1s));
  setup.close();
  ASSERT_FALSE(setup.writer->trouble());
  const std::vector<Seen> seen = setup.messages();
  ASSERT_EQ(seen.size(), 6U);
  EXPECT_EQ(seen[0].topic, "/udp/8/arm");
  EXPECT_EQ(seen[0].publish_time_ns, 12'500'000'000);
  EXPECT_EQ(seen[0].log_time, logTime(1ms));
  EXPECT_EQ(seen[1].topic, "/udp/8/10.0.0.1");
  EXPECT_EQ(seen[1].payload, hostile);
  EXPECT_EQ(seen[1].publish_time_ns, logTime(2ms).time_since_epoch().count());
  EXPECT_EQ(seen[2].topic, "/udp/9/arm");
  EXPECT_EQ(seen[3].topic, "/udp/8/arm");
  EXPECT_EQ(seen[3].sequence, 1U);
  EXPECT_EQ(seen[4].topic, "/rocinante/restated/udp/8/arm");
  EXPECT_EQ(seen[5].topic, "/udp/8/10.0.0.1");
  EXPECT_EQ(seen[5].payload, "");
  EXPECT_EQ(setup.writer->packets(), 6U);
  EXPECT_EQ(setup.writer->restated(), 1U);
  EXPECT_EQ(setup.reader().summary().origin, logTime(1ms));
}

TEST(CaptureWriter, WritesInOrderOfTimeAcrossSockets) {
  Capturing setup;
  setup.arrive(0, logTime(10ms), "a");
  setup.arrive(0, logTime(30ms), "c");
  setup.write(logTime(31ms));
  EXPECT_EQ(setup.writer->packets(), 1U);
  setup.arrive(1, logTime(20ms), "b");
  setup.write(logTime(100ms));
  setup.close();
  std::string order;
  for (const Seen& each : setup.messages()) order += each.payload;
  EXPECT_EQ(order, "abc");
}

TEST(CaptureWriter, GivesEveryBlockBack) {
  Capturing setup;
  for (int round = 0; round < 500; ++round) {
    setup.arrive(0, logTime(1ms * round), std::string(60'000, 'x'));
    setup.write(logTime(1ms * round));
  }
  setup.close();
  EXPECT_EQ(setup.writer->packets(), 500U);
}

TEST(CaptureWriter, EndsAfterExactlyMaxPackets) {
  CaptureLimits limits;
  limits.max_packets = 3;
  Capturing setup(limits);
  for (int i = 0; i < 10; ++i) setup.arrive(0, logTime(1ms * i), std::to_string(i));
  setup.write(logTime(1s));
  EXPECT_TRUE(setup.writer->over());
  setup.close();
  EXPECT_EQ(setup.messages().size(), 3U);
  EXPECT_EQ(setup.writer->accounts()[0].recorded, 3U);
}

TEST(CaptureWriter, EndsBeforeTheMomentUntil) {
  CaptureLimits limits;
  limits.until = logTime(5ms);
  Capturing setup(limits);
  for (int i = 0; i < 10; ++i) setup.arrive(0, logTime(1ms * i), std::to_string(i));
  EndpointLoss after{0, logTime(6ms), logTime(7ms), {}};
  after.counts.kernel = 9;
  setup.write(logTime(1s));
  setup.taken.losses.push_back(after);
  setup.write(logTime(1s));
  setup.close();
  EXPECT_EQ(setup.messages().size(), 5U);
  EXPECT_EQ(setup.writer->lost(), 0U);
}

TEST(CaptureWriter, LossesAreInTheFileWithTheirSpans) {
  Capturing setup;
  setup.arrive(1, logTime(1ms), "x");
  EndpointLoss loss{1, logTime(2ms), logTime(4ms), {}};
  loss.counts = {3, 4, 0, 5};
  setup.taken.losses.push_back(loss);
  setup.write(logTime(10ms));
  setup.close();
  const LogReader log = setup.reader();
  ASSERT_EQ(log.losses().size(), 1U);
  EXPECT_EQ(log.losses()[0].endpoint, "udp://127.0.0.1:9");
  EXPECT_EQ(log.losses()[0].from, logTime(2ms));
  EXPECT_EQ(log.losses()[0].until, logTime(4ms));
  EXPECT_EQ(log.losses()[0].counts, (LossCounts{3, 4, 0, 5}));
  EXPECT_EQ(setup.writer->lost(), 7U);
}

TEST(CaptureWriter, AClockStepIsAMessageInItsPlace) {
  Capturing setup;
  setup.arrive(0, logTime(1ms), "before");
  setup.arrive(0, logTime(9ms), "after");
  setup.taken.steps.push_back({logTime(5ms), -2s});
  setup.write(logTime(10ms));
  setup.write(logTime(100ms));
  setup.close();
  const auto seen = setup.messages();
  ASSERT_EQ(seen.size(), 3U);
  const auto step = std::find_if(seen.begin(), seen.end(),
                                 [](const Seen& each) { return each.topic == "/rocinante/clock"; });
  ASSERT_NE(step, seen.end());
  EXPECT_EQ(step->payload, R"({"noticed_ns":1000005000000,"step_ns":-2000000000})");
}

/// Wherever the disk fills up: recorded + disk = given, and the file holds what was reported as
/// recorded.
TEST(CaptureWriter, AccountsExactlyForWhatTheDiskRefuses) {
  for (std::size_t room = 300; room < 40'000; room += 531) {
    SCOPED_TRACE(room);
    Capturing setup({}, room);
    constexpr std::uint64_t kGiven = 300;
    for (std::uint64_t i = 0; i < kGiven; ++i) {
      setup.arrive(i % 2, logTime(1ms * i), std::string(80, static_cast<char>('a' + i % 26)));
    }
    setup.write(logTime(100ms));
    setup.write(logTime(1s));
    setup.close();
    std::uint64_t recorded = 0;
    std::uint64_t disk = 0;
    for (const EndpointAccount& each : setup.writer->accounts()) {
      recorded += each.recorded;
      disk += each.losses.disk;
    }
    EXPECT_EQ(recorded + disk, kGiven);
    if (disk > 0) {
      EXPECT_TRUE(setup.writer->trouble());
    }
    std::uint64_t found = 0;
    if (auto log = LogReader::openBytes(setup.bytes, "memory")) {
      for (;;) {
        const auto message = log->next();
        if (!message || !*message) break;
        if ((*message)->channel->captured()) ++found;
      }
    }
    EXPECT_EQ(found, recorded);
  }
}

}  // namespace
}  // namespace rocinante
