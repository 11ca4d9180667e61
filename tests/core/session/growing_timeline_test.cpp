#include <gmock/gmock.h>

#include <random>

#include "core/log/log_profile.h"
#include "core/session/marks.h"
#include "core/session/timeline.h"
#include "tests/core/session/session_support.h"
#include "tests/support/temporary_folder.h"

namespace rocinante::test {
namespace {

SessionWriter newPiece(const std::filesystem::path& path, const std::string& session) {
  LogWriterOptions options;
  options.chunk_bytes = 4000;
  auto log = LogWriter::create(path, options, session);
  EXPECT_TRUE(log.ok()) << log.error().text();
  KeyframeOptions keyframes;
  keyframes.packets = 200;
  return SessionWriter(std::move(*log), keyframes);
}

/// The fold by hand of all datagrams up to `moment`.
SessionState foldUpTo(const std::vector<TimedDatagram>& datagrams, LogTime moment) {
  HandFold fold;
  for (const TimedDatagram& each : datagrams) {
    if (each.time > moment) break;
    fold.fold(each.time, bytesOf(each.text));
  }
  return fold.state;
}

TEST(GrowingTimeline, KnowsEveryMomentAsSoonAsItIsWritten) {
  const TemporaryFolder folder;
  const std::vector<TimedDatagram> datagrams = randomDatagrams(7, 500);
  SessionWriter writer = newPiece(folder / "growing.mcap", "s");
  const ChannelId channel = *writer.addChannel("/udp/1/a", "rk1", {});
  std::mt19937 random(3);
  std::optional<Timeline> line;
  std::size_t written = 0;
  while (written < datagrams.size()) {
    const std::size_t until = std::min(datagrams.size(), written + 1 + random() % 60);
    for (; written < until; ++written) {
      const TimedDatagram& each = datagrams[written];
      ASSERT_TRUE(writer.write(channel, 0, each.time, 0, bytesOf(each.text)).ok());
    }
    ASSERT_TRUE(writer.log().flush().ok());
    if (!line) {
      auto opened = Timeline::follow(folder / "growing.mcap");
      ASSERT_TRUE(opened.ok()) << opened.error().text();
      line = std::move(*opened);
    } else {
      ASSERT_TRUE(*line->refresh());
    }
    EXPECT_TRUE(line->growing());
    EXPECT_EQ(line->end(), datagrams[written - 1].time);
    for (int query = 0; query < 4; ++query) {
      const LogTime moment =
          query == 0 ? line->end() : datagrams[random() % written].time + Nanoseconds(random() % 2);
      const auto state = line->stateAt(moment);
      ASSERT_TRUE(state.ok()) << state.error().text();
      ASSERT_TRUE((*state)->sameAs(foldUpTo(datagrams, moment)));
    }
    ASSERT_TRUE(line->events().ok());
  }
  ASSERT_TRUE(writer.log().close("stopped").ok());
  EXPECT_TRUE(*line->refresh());
  EXPECT_FALSE(line->growing());
  EXPECT_FALSE(*line->refresh());
  auto fresh = Timeline::open(folder / "growing.mcap");
  ASSERT_TRUE(fresh.ok());
  const std::vector<Event>& found = **line->events();
  const std::vector<Event>& expected = **fresh->events();
  ASSERT_EQ(found.size(), expected.size());
  ASSERT_FALSE(found.empty());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i].text, expected[i].text);
}

TEST(GrowingTimeline, AMessageOutOfOrderChangesThePast) {
  const TemporaryFolder folder;
  SessionWriter writer = newPiece(folder / "growing.mcap", "s");
  const ChannelId channel = *writer.addChannel("/udp/1/a", "rk1", {});
  const auto put = [&](std::int64_t time, const std::string& text) {
    ASSERT_TRUE(writer.write(channel, 0, at(time), 0, bytesOf(text)).ok());
    ASSERT_TRUE(writer.log().flush().ok());
  };
  put(100, "RK1 a - -\njoints arm 1");
  put(300, "RK1 a - -\njoints hand 3");
  auto line = Timeline::follow(folder / "growing.mcap");
  ASSERT_TRUE(line.ok());
  ASSERT_EQ((*line->stateAt(at(250)))->devices().size(), 1U);
  ASSERT_EQ((*line->stateAt(at(300)))->devices().size(), 2U);
  put(200, "RK1 a - -\njoints late 2");
  EXPECT_TRUE(*line->refresh());
  EXPECT_EQ((*line->stateAt(at(250)))->devices().size(), 2U);
  EXPECT_EQ((*line->stateAt(at(150)))->devices().size(), 1U);
  EXPECT_EQ((*line->stateAt(at(300)))->devices().size(), 3U);
}

struct Pieces {
  explicit Pieces(std::size_t count) : datagrams(randomDatagrams(11, count)) {}

  std::filesystem::path path(int number) const {
    return folder / ("piece-" + std::to_string(number) + ".mcap");
  }
  /// Begins piece `number` with what was written before.
  void begin(int number) {
    std::optional<SessionWriter> before = std::exchange(writer, std::nullopt);
    if (before) {
      ASSERT_TRUE(before->log().close(std::string(profile::kSplitReason)).ok());
    }
    writer.emplace(newPiece(path(number), "s"));
    if (before) {
      writer->log().setOrigin(datagrams.front().time);
      ASSERT_TRUE(writer->beginWith(before->state(), datagrams[written].time).ok());
    }
    channel = *writer->addChannel("/udp/1/a", "rk1", {});
  }
  void write(std::size_t count) {
    for (const std::size_t end = written + count; written < end; ++written) {
      const TimedDatagram& each = datagrams[written];
      ASSERT_TRUE(writer->write(channel, 0, each.time, 0, bytesOf(each.text)).ok());
    }
    ASSERT_TRUE(writer->log().flush().ok());
  }

  TemporaryFolder folder;
  std::vector<TimedDatagram> datagrams;
  std::optional<SessionWriter> writer;
  ChannelId channel = 0;
  std::size_t written = 0;
};

TEST(GrowingTimeline, GoesOnWithTheNextPieceAndLosesDeletedOnes) {
  Pieces pieces(400);
  pieces.begin(1);
  pieces.write(100);
  {
    // Another session beside it does not belong to this one.
    SessionWriter other = newPiece(pieces.folder / "other.mcap", "t");
    const ChannelId channel = *other.addChannel("/udp/1/a", "rk1", {});
    ASSERT_TRUE(other.write(channel, 0, at(99'000'000'000), 0, bytesOf("RK1 x - -\n")).ok());
    ASSERT_TRUE(other.log().close("stopped").ok());
  }
  auto line = Timeline::follow(pieces.path(1));
  ASSERT_TRUE(line.ok());
  const LogTime start = line->start();
  for (const int number : {2, 3}) {
    pieces.begin(number);
    ASSERT_TRUE(line->refresh().ok());
    EXPECT_TRUE(line->growing());
    pieces.write(100);
    ASSERT_TRUE(line->refresh().ok());
    EXPECT_EQ(line->end(), pieces.datagrams[pieces.written - 1].time);
    EXPECT_EQ(line->start(), start);
    EXPECT_EQ(line->origin(), start);
  }
  std::mt19937 random(5);
  for (int query = 0; query < 30; ++query) {
    const LogTime moment = pieces.datagrams[random() % pieces.written].time;
    const auto state = line->stateAt(moment);
    ASSERT_TRUE(state.ok()) << state.error().text();
    ASSERT_EQ((*state)->identityText(), foldUpTo(pieces.datagrams, moment).identityText());
    EXPECT_LE(line->logAt(moment).summary().start, moment);
  }
  EXPECT_EQ(line->log().name(), pieces.path(3).string());
  ASSERT_TRUE(addMark(pieces.path(2), {pieces.datagrams[150].time, {}, "here"}).ok());
  std::filesystem::remove(pieces.path(1));
  ASSERT_TRUE(*line->refresh());
  EXPECT_EQ(line->start(), pieces.datagrams[100].time);
  EXPECT_EQ(line->origin(), start);
  const std::vector<Event>& events = **line->events();
  EXPECT_TRUE(std::ranges::any_of(events, [](const Event& each) { return each.text == "here"; }));
  ASSERT_TRUE(pieces.writer->log().close("stopped").ok());
  ASSERT_TRUE(*line->refresh());
  EXPECT_FALSE(line->growing());
}

TEST(GrowingTimeline, OfAKilledRecorderShowsWhatThereIsAndTellsTheDamage) {
  Pieces pieces(100);
  pieces.begin(1);
  pieces.write(100);
  auto line = Timeline::follow(pieces.path(1));
  ASSERT_TRUE(line.ok());
  EXPECT_TRUE(line->log().damage().empty());
  // A copy of what a killed recorder leaves: nobody has it open for writing.
  const std::filesystem::path killed = pieces.folder / "killed.mcap";
  std::filesystem::copy_file(pieces.path(1), killed);
  auto left = Timeline::follow(killed);
  ASSERT_TRUE(left.ok());
  EXPECT_FALSE(left->growing());
  EXPECT_FALSE(left->log().damage().empty());
  EXPECT_EQ(left->end(), line->end());
  const auto state = left->stateAt(left->end());
  ASSERT_TRUE(state.ok()) << state.error().text();
  EXPECT_TRUE((*state)->sameAs(foldUpTo(pieces.datagrams, left->end())));
}

}  // namespace
}  // namespace rocinante::test
