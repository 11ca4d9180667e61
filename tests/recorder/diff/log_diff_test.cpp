#include "recorder/diff/log_diff.h"

#include <gmock/gmock.h>

#include <random>

#include "tests/core/log/log_support.h"

namespace rocinante::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

struct Given {
  std::int64_t time;
  std::string payload;
  std::string topic = "/udp/1/arm";
};

Bytes logOf(const std::vector<Given>& messages) {
  Bytes file;
  LogWriterOptions options;
  options.chunk_bytes = 4000;
  LogWriter writer = makeWriter(file, options);
  std::map<std::string, ChannelId> channels;
  std::uint32_t sequence = 0;
  for (const Given& each : messages) {
    if (!channels.contains(each.topic)) {
      channels[each.topic] = *writer.addChannel(each.topic, "rk1", {});
    }
    EXPECT_TRUE(writer
                    .write(channels[each.topic], sequence++, at(each.time), each.time,
                           bytesOf(each.payload))
                    .ok());
  }
  EXPECT_TRUE(writer.close("finished").ok());
  return file;
}

LogDiff diffOf(const Bytes& a, const Bytes& b, DiffBy by = DiffBy::all) {
  LogReader reader_a = openLog(a);
  LogReader reader_b = openLog(b);
  Result<LogDiff> diff = diffLogs(reader_a, reader_b, by);
  EXPECT_TRUE(diff.ok()) << diff.error().text();
  return std::move(*diff);
}

LogDiff diffOf(const std::vector<Given>& a, const std::vector<Given>& b, DiffBy by = DiffBy::all) {
  return diffOf(logOf(a), logOf(b), by);
}

std::vector<Given> session(int count) {
  std::vector<Given> messages;
  for (int i = 0; i < count; ++i) {
    const std::string n = std::to_string(i);
    messages.push_back({1000 + i / 2, "RK1 arm " + n + " -\njoints arm " + n});
  }
  return messages;
}

std::string joint(int n) {
  return "RK1 arm " + std::to_string(n) + " -\njoints arm " + std::to_string(n);
}

TEST(LogDiff, OfALogAndItselfIsNone) {
  const LogDiff diff = diffOf(session(100), session(100));
  EXPECT_TRUE(diff.same());
  EXPECT_EQ(diff.payload->same, 100U);
  EXPECT_EQ(diff.messages_b, 100U);
  EXPECT_TRUE(diffOf(std::vector<Given>{}, {}).same());
}

TEST(LogDiff, IsBlindToChunksChannelIdsAndOwnMessages) {
  const std::vector<Given> messages = {{1, joint(0), "/b"}, {2, joint(1), "/a"}};
  std::vector<Given> with_own = messages;
  with_own.insert(with_own.begin() + 1, {1, "{}", "/rocinante/clock"});
  EXPECT_TRUE(diffOf(messages, with_own).same());
}

TEST(LogDiff, FindsWhatOneLogHasAlone) {
  const std::vector<Given> a = session(1000);
  std::vector<Given> b = a;
  b.erase(b.begin() + 500, b.begin() + 510);
  b.push_back({5000, "RK1 other - -"});
  const LogDiff diff = diffOf(a, b);
  EXPECT_EQ(diff.payload->same, 990U);
  EXPECT_EQ(diff.payload->only_a, 10U);
  EXPECT_EQ(diff.payload->only_b, 1U);
  ASSERT_TRUE(diff.payload->first_a && diff.payload->first_b);
  EXPECT_EQ(diff.payload->first_a->number, 500U);
  EXPECT_EQ(diff.payload->first_a->payload, joint(500));
  EXPECT_EQ(diff.payload->first_b->payload, joint(510));
  EXPECT_EQ(diff.time->moved, 0U);
  EXPECT_FALSE(diff.same());
  const LogDiff other_way = diffOf(b, a);
  EXPECT_EQ(other_way.payload->only_a, 1U);
  EXPECT_EQ(other_way.payload->only_b, 10U);
}

TEST(LogDiff, NamesTheTopicAndTheEnd) {
  const LogDiff topic = diffOf({{1, joint(0), "/a"}}, {{1, joint(0), "/b"}});
  EXPECT_TRUE(topic.payload->differs);
  const LogDiff ended = diffOf(session(3), session(2));
  EXPECT_EQ(ended.payload->only_a, 1U);
  EXPECT_FALSE(ended.payload->first_b.has_value());
  EXPECT_THAT(diffText(ended), HasSubstr("first, in b: it has ended"));
}

TEST(LogDiff, GoesOnPastMoreThanItLooksAheadFor) {
  std::vector<Given> a = session(20'000);
  std::vector<Given> b = a;
  for (std::size_t i = 3000; i < 13'000; ++i) b[i].payload += "\nhide arm";
  const LogDiff diff = diffOf(a, b, DiffBy::payload);
  EXPECT_EQ(diff.payload->same, 10'000U);
  EXPECT_EQ(diff.payload->only_a, 10'000U);
  EXPECT_EQ(diff.payload->only_b, 10'000U);
  EXPECT_FALSE(diff.time.has_value());
  EXPECT_FALSE(diff.state.has_value());
}

TEST(LogDiff, TellsHowFarMessagesMoved) {
  const std::vector<Given> a = session(100);
  std::vector<Given> b = a;
  for (std::size_t i = 50; i < b.size(); ++i) b[i].time += 7;
  b[99].time += 100;
  const LogDiff diff = diffOf(a, b, DiffBy::time);
  EXPECT_FALSE(diff.payload->differs);
  EXPECT_EQ(diff.time->moved, 50U);
  EXPECT_EQ(diff.time->least, Nanoseconds(0));
  EXPECT_EQ(diff.time->most, Nanoseconds(107));
  EXPECT_EQ(diff.time->first_a->number, 50U);
  EXPECT_EQ(diff.time->first_shift, Nanoseconds(7));
  EXPECT_EQ(diff.time->largest_a->number, 99U);
  EXPECT_EQ(diff.time->largest_shift, Nanoseconds(107));
  const LogDiff back = diffOf(b, a, DiffBy::time);
  EXPECT_EQ(back.time->largest_shift, Nanoseconds(-107));
  EXPECT_EQ(back.time->least, Nanoseconds(-107));
}

TEST(LogDiff, FindsTheMomentAndTheItemsWhereStatesPart) {
  const std::vector<Given> a = {{10, joint(0)}, {20, joint(1)}, {30, joint(3)}};
  const std::vector<Given> b = {{10, joint(0)}, {20, "RK1 arm 1 -\njoints arm 9"}, {30, joint(3)}};
  const LogDiff diff = diffOf(a, b, DiffBy::state);
  EXPECT_TRUE(diff.state->differs);
  EXPECT_FALSE(diff.state->ends_differ);
  EXPECT_EQ(diff.state->first, at(20));
  EXPECT_THAT(diff.state->only_a, testing::ElementsAre(HasSubstr("joints arm 1")));
  EXPECT_THAT(diff.state->only_b, testing::ElementsAre(HasSubstr("joints arm 9")));
}

TEST(LogDiff, StatesAreTheSameHoweverTheyWereTold) {
  // Different payloads, the same fold: a comment, and two statements in another order.
  const std::vector<Given> a = {{10, "RK1 arm 0 -\nadd a x\nadd b y"}};
  const std::vector<Given> b = {{10, "RK1 arm 0 -\n# a comment\nadd b y\nadd a x"}};
  const LogDiff diff = diffOf(a, b);
  EXPECT_TRUE(diff.payload->differs);
  EXPECT_FALSE(diff.state->differs);
}

TEST(LogDiff, AQuaternionAndItsNegativeAreOneState) {
  const auto posed = [](const char* quaternion, const char* more = "") {
    return std::string("RK1 arm 1 -\npose arm 1 2 3 ") + quaternion + more;
  };
  const std::vector<Given> a = {{1, posed("0 0 -0.6 0.8")}};
  const LogDiff same = diffOf(a, {{1, posed("0 0 0.6 -0.8")}});
  EXPECT_TRUE(same.payload->differs);
  EXPECT_FALSE(same.state->differs || same.state->ends_differ);
  EXPECT_TRUE(diffOf(a, {{1, posed("0 0 0.6 0.8")}}, DiffBy::state).state->differs);
  EXPECT_TRUE(diffOf(a, {{1, posed("0 0 0.6 -0.8", " in cart")}}, DiffBy::state).state->differs);
  // Nor is it named beside another difference.
  const LogDiff other = diffOf(a, {{1, posed("0 0 0.6 -0.8", "\nhide arm")}}, DiffBy::state);
  EXPECT_TRUE(other.state->differs);
  EXPECT_THAT(other.state->only_a, IsEmpty());
  EXPECT_THAT(other.state->only_b, testing::ElementsAre(HasSubstr("hide arm")));
}

TEST(LogDiff, OfRandomCutsCountsExactlyWhatWasTaken) {
  std::mt19937 random(3);
  for (int round = 0; round < 30; ++round) {
    const std::vector<Given> whole = session(400);
    std::vector<Given> a;
    std::vector<Given> b;
    std::uint64_t both = 0;
    for (const Given& each : whole) {
      const bool in_a = random() % 5 != 0;
      const bool in_b = random() % 5 != 0;
      if (in_a) a.push_back(each);
      if (in_b) b.push_back(each);
      both += in_a && in_b ? 1U : 0U;
    }
    const LogDiff diff = diffOf(a, b, DiffBy::payload);
    EXPECT_EQ(diff.payload->same, both);
    EXPECT_EQ(diff.payload->only_a, a.size() - both);
    EXPECT_EQ(diff.payload->only_b, b.size() - both);
  }
}

}  // namespace
}  // namespace rocinante::test
