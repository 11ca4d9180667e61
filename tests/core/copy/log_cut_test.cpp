#include <gmock/gmock.h>

#include <algorithm>

#include "core/base/duration_text.h"
#include "core/copy/log_edits.h"
#include "core/session/marks.h"
#include "tests/core/copy/copy_support.h"

namespace rocinante::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr const char* kTool = "rocinante log cut";

SelectionOptions between(std::int64_t from, std::int64_t until) {
  SelectionOptions selection;
  selection.from = rfcOf(from);
  selection.until = rfcOf(until);
  return selection;
}

TEST(LogCut, APieceHoldsTheMessagesOfItsTimeAndTheStateThatTheSessionHadThere) {
  TemporaryFolder folder;
  std::mt19937_64 random(7);
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    writeRandomLog(folder / "whole.mcap", seed);
    const std::vector<KeptMessage> whole = capturedOf(folder / "whole.mcap");
    for (int each = 0; each < 4; ++each) {
      const std::int64_t a = whole[random() % whole.size()].log_time_ns;
      const std::int64_t b = whole[random() % whole.size()].log_time_ns + 1;
      const std::int64_t from = std::min(a, b - 1);
      const std::int64_t until = std::max(a + 1, b);
      SCOPED_TRACE(testing::Message() << "seed " << seed << " from " << from << " until " << until);
      const std::filesystem::path piece =
          folder / ("piece-" + std::to_string(seed) + "-" + std::to_string(each) + ".mcap");
      const Result<CopyReport> report =
          cutLog(folder / "whole.mcap", between(from, until), makeAt(piece), kTool);
      ASSERT_TRUE(report.ok()) << report.error().text();
      EXPECT_THAT(report->notes, IsEmpty());
      std::vector<KeptMessage> expected;
      for (const KeptMessage& message : whole) {
        if (message.log_time_ns >= from && message.log_time_ns < until) expected.push_back(message);
      }
      EXPECT_EQ(capturedOf(piece), expected);
      expectSameStates(folder / "whole.mcap", piece, from, until);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(LogCut, APieceOfAPieceIsThatOfTheWhole) {
  TemporaryFolder folder;
  for (std::uint64_t seed = 1; seed <= 15; ++seed) {
    SCOPED_TRACE(seed);
    const std::string name = std::to_string(seed);
    writeRandomLog(folder / "whole.mcap", seed);
    const std::vector<KeptMessage> whole = capturedOf(folder / "whole.mcap");
    const std::int64_t from = whole[100].log_time_ns;
    const std::int64_t later = whole[150].log_time_ns;
    const std::int64_t until = whole[250].log_time_ns;
    ASSERT_TRUE(cutLog(folder / "whole.mcap", between(from, until),
                       makeAt(folder / (name + "a.mcap")), kTool)
                    .ok());
    // From before it, from where it begins, from its middle.
    for (const std::int64_t again : {from - 1, from, later}) {
      const std::filesystem::path piece = folder / (name + std::to_string(again) + ".mcap");
      const Result<CopyReport> report =
          cutLog(folder / (name + "a.mcap"), between(again, until), makeAt(piece), kTool);
      ASSERT_TRUE(report.ok()) << report.error().text();
      expectSameStates(folder / "whole.mcap", piece, std::max(again, from), until);
      if (HasFatalFailure()) return;
    }
  }
}

/// The fold of the messages that a selection keeps, computed here.
SessionState foldOfKept(const std::filesystem::path& path, const std::vector<std::string>& topics,
                        std::int64_t until) {
  SessionState state;
  PacketTextDecoder decoder;
  for (const KeptMessage& message : messagesOf(path)) {
    std::string topic = message.topic;
    if (topic.starts_with("/rocinante/restated")) topic.erase(0, 19);
    if (message.log_time_ns > until || std::ranges::find(topics, topic) == topics.end()) continue;
    if (const Packet* packet = decoder.decode(bytesOf(message.payload))) {
      state.apply(at(message.log_time_ns), *packet);
    }
    (void)state.takeEvents();
  }
  return state;
}

TEST(LogCut, WhereChannelsAreDroppedTheStateIsTheFoldOfWhatIsKept) {
  TemporaryFolder folder;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    writeRandomLog(folder / "whole.mcap", seed);
    const std::vector<KeptMessage> whole = capturedOf(folder / "whole.mcap");
    const std::int64_t from = whole[whole.size() / 2].log_time_ns;
    SelectionOptions selection;
    selection.from = rfcOf(from);
    selection.channels = {"/udp/1/a", "/udp/1/z*"};
    const std::filesystem::path piece = folder / ("piece" + std::to_string(seed) + ".mcap");
    const Result<CopyReport> report =
        cutLog(folder / "whole.mcap", selection, makeAt(piece), kTool);
    ASSERT_TRUE(report.ok()) << report.error().text();
    EXPECT_THAT(report->notes, IsEmpty());
    Result<Timeline> timeline = Timeline::open(piece);
    ASSERT_TRUE(timeline.ok());
    for (const KeptMessage& message : capturedOf(piece)) {
      const Result<const SessionState*> state = timeline->stateAt(at(message.log_time_ns));
      ASSERT_TRUE(state.ok());
      const SessionState expected =
          foldOfKept(folder / "whole.mcap", {"/udp/1/a", "/udp/1/z%20z"}, message.log_time_ns);
      ASSERT_TRUE((*state)->sameAs(expected)) << expected.identityText() << "\nbut\n"
                                              << (*state)->identityText();
    }
  }
}

/// A small session whose contents are all known.
class KnownLog : public ::testing::Test {
 protected:
  void SetUp() override {
    Result<LogWriter> log = LogWriter::create(path(), {}, "known");
    ASSERT_TRUE(log.ok());
    SessionWriter session(std::move(*log), {});
    const ChannelId arm = *session.addChannel("/udp/1/arm", "rk1", {{"source", "arm"}});
    const ChannelId cell = *session.addChannel("/udp/1/cell", "rk1", {{"source", "cell"}});
    const ChannelId other = *session.addChannel("/udp/1/x", "octets", {});
    const auto say = [&](ChannelId channel, std::int64_t time, const std::string& text) {
      ASSERT_TRUE(session.write(channel, sequence_++, at(time), time, bytesOf(text)).ok());
    };
    say(arm, 1000, "RK1 arm 0 -\njoints puma 1 2\n");
    say(cell, 2000, "RK1 cell 0 -\npose belt 1 0 0 0 0 0 1\nevent \"pick\"\n");
    ASSERT_TRUE(session.log().writeLoss({"udp://:1", at(1500), at(2500), {3, 0, 0, 0}}).ok());
    say(other, 3000, "bytes");
    say(arm, 4000, "RK1 arm 1 -\njoints puma 3 4\n");
    say(cell, 5000, "RK1 cell 1 -\npose tray 0 0 0 0 0 0 1 in puma/hand\nevent \"place\"\n");
    say(arm, 6000, "RK1 arm 2 -\nevent \"pick\"\n");
    ASSERT_TRUE(session.log().close("stopped").ok());
  }

  std::filesystem::path path() const { return folder_ / "known.mcap"; }
  std::filesystem::path out() const { return folder_ / "out.mcap"; }

  std::vector<std::int64_t> cutTimes(const SelectionOptions& selection) {
    MakeOptions make = makeAt(out());
    make.overwrite = true;
    const Result<CopyReport> report = cutLog(path(), selection, make, kTool);
    EXPECT_TRUE(report.ok()) << report.error().text();
    std::vector<std::int64_t> times;
    for (const KeptMessage& message : capturedOf(out())) times.push_back(message.log_time_ns);
    return times;
  }
  std::string refusal(const SelectionOptions& selection) {
    const Result<CopyReport> report = cutLog(path(), selection, makeAt(out()), kTool);
    EXPECT_FALSE(report.ok());
    EXPECT_FALSE(std::filesystem::exists(out()));
    return report.ok() ? "" : report.error().text();
  }

  using Times = std::vector<std::int64_t>;
  TemporaryFolder folder_;
  std::uint32_t sequence_ = 0;
};

TEST_F(KnownLog, IsCutByEvents) {
  SelectionOptions selection;
  selection.from_event = "pick";
  selection.until_event = "pl*";
  EXPECT_EQ(cutTimes(selection), (Times{2000, 3000, 4000}));
  // The event that begins the range does not end it.
  selection.until_event = "pick";
  EXPECT_EQ(cutTimes(selection), (Times{2000, 3000, 4000, 5000}));
}

TEST_F(KnownLog, IsCutByAMarkThatAPersonSet) {
  ASSERT_TRUE(addMark(path(), {at(3500), {}, "slipped"}).ok());
  SelectionOptions selection;
  selection.from_event = "slipped";
  EXPECT_EQ(cutTimes(selection), (Times{4000, 5000, 6000}));
}

TEST_F(KnownLog, AnEventThatIsNotThereIsRefused) {
  SelectionOptions selection;
  selection.from_event = "drop";
  EXPECT_THAT(refusal(selection), HasSubstr("no event matches (drop)"));
  selection.from_event = "place";
  selection.until_event = "place";
  EXPECT_THAT(refusal(selection), HasSubstr("no event matches after the start"));
}

TEST_F(KnownLog, ARangeThatIsEmptyOrHoldsNothingIsRefused) {
  EXPECT_THAT(refusal(between(4000, 4000)), HasSubstr("ends before it begins"));
  EXPECT_THAT(refusal(between(4001, 4999)), HasSubstr("no message was chosen"));
  EXPECT_THAT(refusal(between(7000, 8000)), HasSubstr("no message was chosen"));
}

TEST_F(KnownLog, IsFilteredBySourceDeviceAndEncoding) {
  SelectionOptions selection;
  selection.sources = {"arm"};
  EXPECT_EQ(cutTimes(selection), (Times{1000, 4000, 6000}));
  selection.sources.clear();
  // The puma carries the tray: the statement is about both.
  selection.devices = {"puma"};
  EXPECT_EQ(cutTimes(selection), (Times{1000, 4000, 5000}));
  selection.devices = {"belt", "tray"};
  EXPECT_EQ(cutTimes(selection), (Times{2000, 5000}));
  selection.devices.clear();
  selection.encodings = {"octets"};
  EXPECT_EQ(cutTimes(selection), (Times{3000}));
  selection.encodings.clear();
  selection.not_channels = {"*/cell", "*/x"};
  EXPECT_EQ(cutTimes(selection), (Times{1000, 4000, 6000}));
}

TEST_F(KnownLog, LossesGoWithTheTimeAtWhichTheirSpanEnds) {
  const auto lossesOf = [&](std::int64_t from, std::int64_t until) {
    cutTimes(between(from, until));
    return openLogAt(out()).losses().size();
  };
  EXPECT_EQ(lossesOf(1000, 2400), 0U);
  EXPECT_EQ(lossesOf(1000, 2500), 1U);
  EXPECT_EQ(lossesOf(2499, 9000), 1U);
  EXPECT_EQ(lossesOf(2500, 9000), 0U);
}

TEST_F(KnownLog, MarksBesideItAreBakedInOnce) {
  ASSERT_TRUE(addMark(path(), {at(2000), {}, "slipped"}).ok());
  ASSERT_TRUE(addMark(path(), {at(9000), {}, "later"}).ok());
  cutTimes(between(1000, 6500));
  std::vector<KeptMessage> messages = messagesOf(out());
  ASSERT_EQ(countOn(messages, "/rocinante/mark"), 1U);
  EXPECT_EQ(messages[2].topic, "/rocinante/mark");  // after the message of its time
  // Marks in the log are kept, and an equal one beside the log is not added again.
  ASSERT_TRUE(addMark(out(), {at(2000), {}, "slipped"}).ok());
  ASSERT_TRUE(addMark(out(), {at(2000), {}, "twice"}).ok());
  const std::filesystem::path again = folder_ / "again.mcap";
  SelectionOptions all;
  all.from = "0";
  ASSERT_TRUE(cutLog(out(), all, makeAt(again), kTool).ok());
  EXPECT_EQ(countOn(messagesOf(again), "/rocinante/mark"), 2U);
}

TEST_F(KnownLog, KeepsWhatNamesAMomentAndSaysWhichToolMadeIt) {
  cutTimes(between(4000, 6000));
  const LogReader reader = openLogAt(out());
  EXPECT_EQ(reader.summary().session_id, "known");
  EXPECT_EQ(reader.summary().origin, at(1000));
  EXPECT_EQ(reader.summary().end_reason, kTool);
}

TEST_F(KnownLog, AnExistingOutputAndAnInputAreNotOverwritten) {
  cutTimes(between(1000, 2000));
  const Result<CopyReport> exists = cutLog(path(), between(1000, 2000), makeAt(out()), kTool);
  ASSERT_FALSE(exists.ok());
  EXPECT_THAT(exists.error().text(), HasSubstr("--force"));
  MakeOptions force = makeAt(path());
  force.overwrite = true;
  const std::filesystem::path link = folder_ / "link.mcap";
  std::filesystem::create_symlink(path(), link);
  for (const std::filesystem::path& input : {path(), link}) {
    force.output = input;
    const Result<CopyReport> refused = cutLog(path(), between(1000, 2000), force, kTool);
    ASSERT_FALSE(refused.ok());
    EXPECT_THAT(refused.error().text(), HasSubstr("would overwrite an input"));
  }
  force.output = "/dev/null";
  EXPECT_FALSE(cutLog(path(), between(1000, 2000), force, kTool).ok());
}

TEST_F(KnownLog, NothingIsLeftBehindWhereTheWorkIsStopped) {
  MakeOptions make = makeAt(out());
  make.progress = [](double) -> Status { return Error{ErrorKind::refused, "stopped", {}}; };
  writeRandomLog(path(), 1, {.count = 6000});
  SelectionOptions all;
  all.from = "0";
  const Result<CopyReport> report = cutLog(path(), all, make, kTool);
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().what, "stopped");
  for (const auto& file : std::filesystem::directory_iterator(folder_.path())) {
    EXPECT_EQ(file.path().filename(), "known.mcap");
  }
}

}  // namespace
}  // namespace rocinante::test
