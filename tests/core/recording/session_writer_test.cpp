#include "core/recording/session_writer.h"

#include <gmock/gmock.h>

#include "core/log/log_profile.h"
#include "core/session/keyframe.h"
#include "tests/core/session/session_support.h"

namespace rocinante::test {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

/// Writes `count` packets of one arm, one every `step_ns`, from one second on.
class Arm {
 public:
  Arm(SessionWriter& session, std::int64_t step_ns) : session_(session), step_ns_(step_ns) {
    channel_ = *session.addChannel("/udp/19960/arm", "rk1", {});
  }
  void say(std::size_t count, const std::string& words = "", const std::string& rest = "") {
    for (std::size_t i = 0; i < count; ++i) {
      const std::string text = "RK1 arm@a " + std::to_string(sequence_) + " -" + words +
                               "\njoints arm 0.5 " + std::to_string(sequence_) +
                               " 1 2 3 4 5 6 7\n" + rest;
      EXPECT_TRUE(session_.write(channel_, sequence_, now(), 0, bytesOf(text)).ok());
      ++sequence_;
    }
  }
  void wait(std::int64_t nanoseconds) { waited_ns_ += nanoseconds; }
  LogTime now() const { return at(kSecond + sequence_ * step_ns_ + waited_ns_); }

 private:
  SessionWriter& session_;
  std::int64_t step_ns_;
  std::int64_t waited_ns_ = 0;
  ChannelId channel_ = 0;
  std::uint32_t sequence_ = 0;
};

KeyframeOptions every(std::uint64_t packets, Nanoseconds span = std::chrono::seconds(10)) {
  KeyframeOptions options;
  options.packets = packets;
  options.span = span;
  return options;
}

/// The number of packets before each keyframe of a log.
std::vector<std::size_t> keyframePlaces(const Bytes& file) {
  LogReader reader = openLog(file);
  std::vector<std::size_t> places;
  std::size_t packets = 0;
  for (const KeptMessage& message : readAll(reader)) {
    if (message.topic == profile::kKeyframeTopic) {
      places.push_back(packets);
    } else {
      ++packets;
    }
  }
  EXPECT_TRUE(reader.damage().empty());
  return places;
}

/// Every keyframe must be the fold of the messages before it. Returns the number of keyframes.
std::size_t expectKeyframesAreTheFold(const Bytes& file, const SessionState& preceding = {}) {
  LogReader reader = openLog(file);
  KeyframeReader keyframes;
  HandFold fold;
  fold.state = preceding;
  std::size_t count = 0;
  for (const KeptMessage& message : readAll(reader)) {
    const LogTime time = at(message.log_time_ns);
    if (message.topic != profile::kKeyframeTopic) {
      fold.fold(time, bytesOf(message.payload));
      continue;
    }
    SCOPED_TRACE(message.payload);
    ++count;
    const Result<SessionState> told = keyframes.read(bytesOf(message.payload), time);
    if (!told.ok()) {
      ADD_FAILURE() << told.error().text();
      continue;
    }
    EXPECT_EQ(told->identityText(), fold.state.identityText());
    EXPECT_TRUE(told->sameAs(fold.state));
    EXPECT_EQ(told->weight(), fold.state.weight());
    EXPECT_FALSE(told->restatementOpen());
  }
  return count;
}

TEST(SessionWriter, WritesAKeyframeAfterSoManyPackets) {
  Bytes file;
  SessionWriter session = makeSession(file, every(20));
  Arm(session, 1'000'000).say(65);
  EXPECT_EQ(session.keyframes(), 3U);
  ASSERT_TRUE(session.log().close("finished").ok());
  EXPECT_THAT(keyframePlaces(file), ::testing::ElementsAre(20, 40, 60));
  EXPECT_EQ(expectKeyframesAreTheFold(file), 3U);
  LogReader reader = openLog(file);
  EXPECT_EQ(reader.summary().messages, 65U);  // keyframes do not count as messages
}

TEST(SessionWriter, WritesAKeyframeAfterSoMuchTimeIfAnythingCame) {
  Bytes file;
  SessionWriter session = makeSession(file, every(20'000));
  Arm arm(session, kSecond);
  arm.say(25);
  arm.wait(100 * kSecond);  // one keyframe covers the pause
  arm.say(2);
  ASSERT_TRUE(session.log().close("finished").ok());
  EXPECT_THAT(keyframePlaces(file), ::testing::ElementsAre(10, 19, 25));
}

TEST(SessionWriter, AKeyframeHasTheTimeOfTheLastMessageBeforeIt) {
  Bytes file;
  SessionWriter session = makeSession(file, every(4));
  Arm(session, kSecond).say(6, "", "# " + std::string(200, 'x') + '\n');
  ASSERT_TRUE(session.log().close("finished").ok());
  LogReader reader = openLog(file);
  const std::vector<KeptMessage> messages = readAll(reader);
  ASSERT_EQ(messages.size(), 7U);
  EXPECT_EQ(messages[4].topic, profile::kKeyframeTopic);
  EXPECT_EQ(messages[4].log_time_ns, messages[3].log_time_ns);
  EXPECT_EQ(messages[4].payload,
            "RK1 arm@a 3 - restated part=k:1/1 by=keyframe\n"
            "order arm\n"
            "joints arm 0.5 3 1 2 3 4 5 6 7\n"
            "seen arm 4000000000\n");
}

TEST(SessionWriter, WaitsForAnUnfinishedRestatement) {
  Bytes file;
  SessionWriter session = makeSession(file, every(10));
  Arm arm(session, 1'000'000);
  arm.say(9);
  arm.say(1, " restated part=r:1/2");
  arm.say(5);  // no keyframe before any of these
  arm.say(1, " restated part=r:2/2");
  arm.say(1);
  arm.say(8, " restated part=s:1/2");  // never completed, and not timed out yet
  arm.wait(kSecond);
  arm.say(2);
  ASSERT_TRUE(session.log().close("finished").ok());
  EXPECT_THAT(keyframePlaces(file), ::testing::ElementsAre(16, 26));
  EXPECT_EQ(expectKeyframesAreTheFold(file), 2U);
}

TEST(SessionWriter, KeyframesStayUnderAQuarterOfWhatIsStored) {
  Bytes file;
  SessionWriter session = makeSession(file, every(1));
  Arm arm(session, 1'000'000);
  std::string drawing = "points cloud #ff0000";
  for (int i = 0; i < 3000; ++i) drawing += " 1";
  arm.say(1, "", drawing + "\n");
  arm.say(3000);
  ASSERT_TRUE(session.log().close("finished").ok());
  LogReader reader = openLog(file);
  std::size_t keyframes = 0;
  std::size_t all = 0;
  std::size_t count = 0;
  for (const KeptMessage& message : readAll(reader)) {
    all += message.payload.size();
    if (message.topic != profile::kKeyframeTopic) continue;
    ++count;
    keyframes += message.payload.size();
    EXPECT_LE(4 * keyframes, all);
  }
  EXPECT_GE(count, 4U);
  EXPECT_LE(count, 40U);
}

TEST(SessionWriter, WritesNoneWhenToldSo) {
  Bytes file;
  KeyframeOptions off = every(1);
  off.enabled = false;
  SessionWriter session = makeSession(file, off);
  Arm(session, 1'000'000).say(50);
  EXPECT_TRUE(session.state().devices().empty());
  ASSERT_TRUE(session.log().close("finished").ok());
  EXPECT_THAT(keyframePlaces(file), ::testing::ElementsAre());
}

TEST(SessionWriter, KeyframesAreTheFoldWhateverIsSaid) {
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    Bytes file;
    SessionWriter session = makeSession(file, every(5, std::chrono::milliseconds(300)));
    const ChannelId spoken = *session.addChannel("/udp/1/x", "rk1", {});
    const ChannelId restated = *session.addChannel("/rocinante/restated/udp/1/x", "rk1", {});
    const ChannelId octets = *session.addChannel("/udp/1/127.0.0.1", "octets", {});
    const std::string filler(200, 'x');  // or keyframes would be over a quarter
    HandFold fold;
    std::uint32_t number = 0;
    for (const TimedDatagram& said : randomDatagrams(seed, 400)) {
      const bool is_restated = said.text.find(" by=") != std::string::npos;
      ASSERT_TRUE(
          session.write(is_restated ? restated : spoken, number++, said.time, 0, bytesOf(said.text))
              .ok());
      fold.fold(said.time, bytesOf(said.text));
      for (int i = 0; i < 20; ++i) {
        ASSERT_TRUE(session.write(octets, number++, said.time, 0, bytesOf(filler)).ok());
      }
    }
    EXPECT_TRUE(session.state().sameAs(fold.state));
    ASSERT_TRUE(session.log().close("finished").ok());
    const std::size_t count = expectKeyframesAreTheFold(file);
    EXPECT_EQ(count, session.keyframes());
    found += count;
  }
  EXPECT_GE(found, 500U);
}

TEST(SessionWriter, APieceOpensWithWhatPreceded) {
  HandFold before;
  for (const TimedDatagram& said : randomDatagrams(3, 200)) {
    before.fold(at(said.time.time_since_epoch().count() / 1000), bytesOf(said.text));
  }
  Bytes file;
  SessionWriter session = makeSession(file, every(20));
  ASSERT_TRUE(session.beginWith(before.state, at(kSecond)).ok());
  EXPECT_TRUE(session.state().sameAs(before.state));
  EXPECT_EQ(session.keyframes(), 1U);
  Arm(session, 1'000'000).say(30);
  const Status again = session.beginWith(before.state, at(2 * kSecond));
  ASSERT_FALSE(again.ok());
  EXPECT_EQ(again.error().kind, ErrorKind::bad_argument);
  ASSERT_TRUE(session.log().close("finished").ok());
  EXPECT_EQ(keyframePlaces(file).front(), 0U);
  EXPECT_GE(expectKeyframesAreTheFold(file, before.state), 1U);
}

TEST(SessionWriter, APieceThatNothingPrecededNeedsNoKeyframe) {
  Bytes file;
  SessionWriter session = makeSession(file, {});
  ASSERT_TRUE(session.beginWith({}, at(kSecond)).ok());
  EXPECT_EQ(session.keyframes(), 0U);
}

TEST(SessionWriter, CopiedKeyframesAreRefused) {
  Bytes file;
  SessionWriter session = makeSession(file, {});
  const auto refused = session.addChannel(std::string(profile::kKeyframeTopic),
                                          std::string(profile::kKeyframeEncoding), {});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().kind, ErrorKind::refused);
}

TEST(SessionWriter, AfterAPacketThatGoesBackThereAreNoMoreKeyframes) {
  Bytes file;
  SessionWriter session = makeSession(file, every(10));
  Arm arm(session, 1'000'000);
  arm.say(15);
  arm.wait(-5'000'000);
  arm.say(40);
  ASSERT_TRUE(session.log().close("finished").ok());
  EXPECT_EQ(session.keyframes(), 1U);
}

TEST(SessionWriter, MarksAreNoPackets) {
  Bytes file;
  SessionWriter session = makeSession(file, every(2));
  Arm arm(session, 1'000'000);
  arm.say(1);
  ASSERT_TRUE(session.writeMark(arm.now(), "here \"it\" broke").ok());
  arm.say(1);
  ASSERT_TRUE(session.log().close("finished").ok());
  LogReader reader = openLog(file);
  const std::vector<KeptMessage> messages = readAll(reader);
  ASSERT_EQ(messages.size(), 3U);
  EXPECT_EQ(messages[1].topic, profile::kMarkTopic);
  EXPECT_EQ(session.keyframes(), 0U);
}

}  // namespace
}  // namespace rocinante::test
