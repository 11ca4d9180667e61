#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "core/log/mcap_stream_reader.h"
#include "tests/core/log/log_steps.h"

namespace rocinante::test {
namespace {

using ::testing::ElementsAreArray;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::vector<KeptMessage> readBackwards(LogReader& reader) {
  std::vector<KeptMessage> messages;
  while (true) {
    const Result<std::optional<LogMessage>> message = reader.previous();
    if (!message.ok() || !*message) break;
    messages.push_back(keep(**message));
  }
  return messages;
}

Ending anyEnding() {
  return *rc::gen::element(Ending::closed, Ending::without_magic, Ending::killed);
}

RC_GTEST_PROP(LogDirection, BackwardsIsForwardsReversedFromAnyMoment, ()) {
  const std::vector<Step> written = *steps();
  const Bytes file = writeSteps(written, anyOptions(), anyEnding());
  LogReader reader = openLog(file);
  RC_ASSERT(readBackwards(reader).empty());
  for (int i = 0; i < 3; ++i) {
    const std::int64_t moment = *rc::gen::inRange(0, 61);
    std::vector<KeptMessage> before = expected(written);
    std::erase_if(before, [&](const KeptMessage& each) { return each.log_time_ns >= moment; });
    std::ranges::reverse(before);
    RC_ASSERT(reader.seek(at(moment)).ok());
    RC_ASSERT(readBackwards(reader) == before);
    // And there and back again.
    RC_ASSERT(readAll(reader) == expected(written));
    std::vector<KeptMessage> all = expected(written);
    std::ranges::reverse(all);
    RC_ASSERT(readBackwards(reader) == all);
  }
}

/// Any steps in both directions, with jumps between, against a plain list.
RC_GTEST_PROP(LogDirection, AnyWalkGoesOverTheSameMessages, ()) {
  const std::vector<Step> written = *steps();
  const Bytes file = writeSteps(written, anyOptions(), anyEnding());
  const std::vector<KeptMessage> all = expected(written);
  LogReader reader = openLog(file);
  std::vector<LogPlace> places;
  while (const std::optional<LogMessage> message = *reader.next()) {
    places.push_back(message->place());
  }
  RC_ASSERT(places.size() == all.size());
  std::size_t here = all.size();
  const auto moves = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 12));
  for (const int move : moves) {
    if (move == 0) {
      const std::int64_t moment = *rc::gen::inRange(0, 61);
      RC_ASSERT(reader.seek(at(moment)).ok());
      here = all.size() - expected(written, moment).size();
    } else if (move == 1 && !all.empty()) {
      const auto after = *rc::gen::inRange<std::size_t>(0, all.size());
      RC_ASSERT(reader.seekAfter(places[after]).ok());
      here = after + 1;
    } else if (move % 2 == 0) {
      const std::optional<LogMessage> message = *reader.next();
      RC_ASSERT(message.has_value() == (here < all.size()));
      if (message) RC_ASSERT(keep(*message) == all[here++]);
    } else {
      const std::optional<LogMessage> message = *reader.previous();
      RC_ASSERT(message.has_value() == (here > 0));
      if (message) RC_ASSERT(keep(*message) == all[--here]);
    }
  }
}

RC_GTEST_PROP(LogDirection, TheLastOfAChannelIsFoundFromAnywhere, ()) {
  const std::vector<Step> written = *steps();
  const Bytes file = writeSteps(written, anyOptions(), anyEnding());
  LogReader reader = openLog(file);
  // By channel, not by topic: several channels share one.
  struct Last {
    std::int64_t time_ns;
    std::string payload;
  };
  for (int i = 0; i < 6; ++i) {
    const int channel = *rc::gen::inRange(0, 5);
    const std::int64_t moment = *rc::gen::inRange(-1, 61);
    std::optional<Last> wanted;
    for (const Step& step : written) {
      if (step.channel != channel || step.time_ns > moment) continue;
      if (!wanted || step.time_ns >= wanted->time_ns) wanted = {step.time_ns, step.payload};
    }
    const Result<std::optional<LogMessage>> next = reader.next();
    RC_ASSERT(next.ok());
    const std::optional<LogPlace> place = *next ? std::optional((*next)->place()) : std::nullopt;
    const std::optional<LogMessage> last =
        *reader.lastOf(static_cast<ChannelId>(channel), at(moment));
    RC_ASSERT(last.has_value() == wanted.has_value());
    if (last) {
      RC_ASSERT(last->channel->id == channel);
      RC_ASSERT(last->log_time == at(wanted->time_ns));
      RC_ASSERT(textOf(last->payload) == wanted->payload);
    }
    // The reader has not moved.
    const std::optional<LogMessage> same = *reader.previous();
    RC_ASSERT(same.has_value() == place.has_value());
    if (same) RC_ASSERT(same->place() == *place);
  }
  // That the file was not closed is damage, and nothing else is.
  for (const DamageSpan& damage : reader.damage()) {
    RC_ASSERT(damage.cause.find("never") != std::string::npos ||
              damage.cause.find("the file ends inside its summary") != std::string::npos);
  }
}

/// A chunk's message index made to lie: the messages are followed, and it is told.
TEST(LogDirection, AMessageIndexIsBelievedOnlyWhereItAgreesWithTheMessage) {
  Bytes file;
  LogWriterOptions options;
  options.compression = LogWriterOptions::Compression::none;
  LogWriter writer = makeWriter(file, options);
  const ChannelId a = *writer.addChannel("/udp/1/a", "octets", {});
  for (std::int64_t i = 0; i < 10; ++i) {
    const std::string payload = "payload " + std::to_string(i);
    ASSERT_TRUE(writer.write(a, 0, at(1000 + i), 1, bytesOf(payload)).ok());
  }
  ASSERT_TRUE(writer.close("finished").ok());
  std::uint64_t position = 8;
  std::optional<mcap::Record> record;
  while ((record = mcap::recordAt(file, position))->opcode != mcap::Opcode::message_index) {
    position = record->end();
  }
  // The entry of the message at 1005 says 1002.
  const std::size_t entry = static_cast<std::size_t>(position) + 9 + 6 + 5 * 16;
  ASSERT_EQ(std::to_integer<int>(file[entry]), 1005 & 0xFF);
  file[entry] = std::byte{1002 & 0xFF};
  {
    // What it hides behind the moment is not asked for: the right message all the same.
    LogReader reader = openLog(file);
    const std::optional<LogMessage> last = *reader.lastOf(a, at(1007));
    ASSERT_TRUE(last.has_value());
    EXPECT_EQ(textOf(last->payload), "payload 7");
    EXPECT_THAT(reader.damage(), IsEmpty());
  }
  LogReader reader = openLog(file);
  const std::optional<LogMessage> last = *reader.lastOf(a, at(1005));
  ASSERT_TRUE(last.has_value());
  EXPECT_EQ(textOf(last->payload), "payload 5");
  ASSERT_THAT(reader.damage(), SizeIs(1));
  EXPECT_LE(reader.damage()[0].from, entry);
  EXPECT_GT(reader.damage()[0].to, entry);
}

TEST(LogDirection, BehindAPlaceThatHoldsNoMessageTheNextOneComes) {
  Bytes file;
  LogWriter writer = makeWriter(file);
  const ChannelId a = *writer.addChannel("/udp/1/a", "octets", {});
  for (std::int64_t i = 0; i < 3; ++i) {
    ASSERT_TRUE(writer.write(a, 0, at(10 * i), 1, bytesOf("x")).ok());
  }
  ASSERT_TRUE(writer.close("finished").ok());
  LogReader reader = openLog(file);
  constexpr auto kLast = std::numeric_limits<std::uint64_t>::max();
  ASSERT_TRUE(reader.seekAfter({at(10), kLast}).ok());
  EXPECT_EQ((*reader.next())->log_time, at(20));
  ASSERT_TRUE(reader.seekAfter({LogTime::max(), kLast}).ok());
  EXPECT_FALSE(reader.next()->has_value());
  EXPECT_EQ((*reader.previous())->log_time, at(20));
  ASSERT_TRUE(reader.seekAfter({LogTime::min(), 0}).ok());
  EXPECT_FALSE(reader.previous()->has_value());
  EXPECT_EQ((*reader.next())->log_time, at(0));
}

TEST(LogDirection, ALogWithoutMessagesIsEmptyEitherWay) {
  Bytes file;
  LogWriter writer = makeWriter(file);
  ASSERT_TRUE(writer.close("finished").ok());
  LogReader reader = openLog(file);
  EXPECT_FALSE(reader.next()->has_value());
  EXPECT_FALSE(reader.previous()->has_value());
  EXPECT_FALSE(reader.lastOf(0, at(1))->has_value());
  EXPECT_FALSE(reader.lastOf(65535, LogTime::max())->has_value());
  EXPECT_THAT(reader.damage(), IsEmpty());
}

}  // namespace
}  // namespace rocinante::test
