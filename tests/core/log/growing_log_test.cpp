#include <gmock/gmock.h>

#include <random>

#include "tests/core/log/followed_log.h"
#include "tests/core/log/write_history.h"
#include "tests/support/next_place.h"

namespace rocinante::test {
namespace {

class LogFollowerOfAGrowingFile : public testing::TestWithParam<bool> {};

TEST_P(LogFollowerOfAGrowingFile, GivesEveryMessageAsSoonAsItIsWholeAndNeverHalfOfOne) {
  WriteHistory history(GetParam());
  record(history);
  Bytes file;
  LogFollower follower = follow(file);
  std::vector<KeptMessage> messages;
  const std::vector<KeptMessage>& all = history.messages();
  const auto look = [&] {
    const std::size_t before = messages.size();
    ASSERT_TRUE(drain(follower, messages));
    ASSERT_LE(messages.size(), all.size());
    for (std::size_t i = before; i < messages.size(); ++i) ASSERT_EQ(messages[i], all[i]);
  };
  for (const WriteHistory::Write& write : history.writes()) {
    ASSERT_FALSE(follower.ended());
    if (write.offset) {
      // Torn between two pages of memory, at every place.
      const Bytes before = file;
      for (std::size_t part = 1; part < write.bytes.size(); ++part) {
        file = before;
        WriteHistory::apply(file, {write.offset, cutAt(write.bytes, part)});
        look();
      }
      WriteHistory::apply(file, write);
    } else {
      for (const std::byte byte : write.bytes) {
        file.push_back(byte);
        look();
      }
    }
    look();
    EXPECT_GE(messages.size(), write.messages);
  }
  EXPECT_EQ(messages, all);
  EXPECT_TRUE(follower.ended());
  EXPECT_TRUE(follower.takeDamage().empty());
  EXPECT_EQ(follower.origin(), at(1000));
}

TEST_P(LogFollowerOfAGrowingFile, GivesTheSameWhereverItComesIn) {
  WriteHistory history(GetParam());
  record(history);
  for (std::size_t done = 0; done <= history.writes().size(); ++done) {
    const Bytes first = history.after(done);
    const std::size_t last_bytes = done == 0 || history.writes()[done - 1].offset
                                       ? 0
                                       : history.writes()[done - 1].bytes.size();
    for (std::size_t missing = 0; missing <= last_bytes; missing += nextPlace()) {
      SCOPED_TRACE(std::to_string(done) + " writes less " + std::to_string(missing));
      Bytes file = cutAt(first, first.size() - missing);
      LogFollower from_start = follow(file);
      LogFollower from_now = follow(file, LogFollower::From::now);
      std::vector<KeptMessage> whole;
      std::vector<KeptMessage> fresh;
      ASSERT_TRUE(drain(from_start, whole));
      ASSERT_TRUE(drain(from_now, fresh));
      EXPECT_THAT(fresh, testing::IsEmpty());
      const std::size_t there = whole.size();

      file = first;
      for (std::size_t i = done; i < history.writes().size(); ++i) {
        WriteHistory::apply(file, history.writes()[i]);
      }
      ASSERT_TRUE(drain(from_start, whole));
      ASSERT_TRUE(drain(from_now, fresh));
      EXPECT_EQ(whole, history.messages());
      EXPECT_EQ(fresh, std::vector<KeptMessage>(
                           history.messages().begin() + static_cast<std::ptrdiff_t>(there),
                           history.messages().end()));
      EXPECT_TRUE(from_start.ended());
      EXPECT_TRUE(from_now.ended());
      EXPECT_TRUE(from_start.takeDamage().empty());
      EXPECT_TRUE(from_now.takeDamage().empty());
    }
  }
}

TEST_P(LogFollowerOfAGrowingFile, NoticesAHeaderThatIsNotThatOfTheChunk) {
  WriteHistory history(GetParam());
  history.beginOpenChunk();
  history.addMessages(2);
  history.endOpenChunk(1);
  history.finish();
  // Offsets in the header: end of the uncompressed size, checksum, length of the records.
  for (const std::size_t wrong : {25U, 33U, GetParam() ? 45U : 41U}) {
    SCOPED_TRACE(wrong);
    Bytes file;
    LogFollower follower = follow(file);
    std::vector<KeptMessage> messages;
    for (WriteHistory::Write write : history.writes()) {
      if (write.offset) write.bytes[wrong] ^= std::byte{1};
      WriteHistory::apply(file, write);
      ASSERT_TRUE(drain(follower, messages));
    }
    EXPECT_EQ(messages.size(), 3U);
    EXPECT_TRUE(follower.ended());
    const std::vector<DamageSpan> damage = follower.takeDamage();
    ASSERT_EQ(damage.size(), 1U);
    EXPECT_THAT(damage[0].cause, testing::HasSubstr("does not match what was read"));
  }
}

TEST_P(LogFollowerOfAGrowingFile, TakesAChunkForOpenByTheReadersRule) {
  WriteHistory history(GetParam());
  history.beginOpenChunk();
  history.addMessages(2);
  history.endOpenChunk(1);
  history.finish();
  // The completion of the header was torn: one field still has its value from the beginning.
  // Offsets of the length, the end time and the uncompressed size.
  for (const std::ptrdiff_t open : {1, 17, 25}) {
    SCOPED_TRACE(open);
    Bytes file;
    for (WriteHistory::Write write : history.writes()) {
      if (write.offset) std::fill_n(write.bytes.begin() + open, 8, std::byte{0xFF});
      WriteHistory::apply(file, write);
    }
    LogFollower follower = follow(file);
    std::vector<KeptMessage> messages;
    std::string why;
    ASSERT_TRUE(drain(follower, messages, &why)) << why;
    LogReader reader = openLog(file);
    EXPECT_EQ(messages, readAll(reader));
    EXPECT_EQ(messages.size(), 3U);
    EXPECT_TRUE(follower.ended());
    const std::vector<DamageSpan> damage = follower.takeDamage();
    ASSERT_EQ(damage.size(), 1U);
    EXPECT_THAT(damage[0].cause, testing::HasSubstr("was never closed"));
  }
}

TEST_P(LogFollowerOfAGrowingFile, BearsEveryFlippedBit) {
  WriteHistory history(GetParam());
  record(history);
  const Bytes whole = history.after(history.writes().size());
  for (std::size_t bit = 0; bit < whole.size() * 8; bit += 3 * nextPlace()) {
    Bytes file = whole;
    file[bit / 8] ^= static_cast<std::byte>(1U << (bit % 8));
    Result<LogFollower> follower =
        LogFollower::openOn(std::make_unique<FakeFile>(file), LogFollower::From::start);
    if (!follower.ok()) continue;
    std::vector<KeptMessage> messages;
    (void)drain(*follower, messages);
    // Every message returned was written, in this order: checksums cover them all.
    std::size_t next = 0;
    for (const KeptMessage& message : messages) {
      while (next < history.messages().size() && history.messages()[next] != message) ++next;
      EXPECT_LT(next++, history.messages().size()) << "changed, bit " << bit;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Compressed, LogFollowerOfAGrowingFile, testing::Values(false, true));

}  // namespace
}  // namespace rocinante::test
