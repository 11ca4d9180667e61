#include <gmock/gmock.h>

#include <limits>

#include "core/mcap/record_stepper.h"
#include "tests/core/log/log_support.h"

namespace rocinante::test {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

/// A chunk's message index is wrong: the messages are used, and the damage is reported.
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
    // The wrong entry does not matter at this moment: the result is right.
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
