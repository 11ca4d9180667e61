#include "core/log/log_follower.h"

#include <gmock/gmock.h>
#include <zstd.h>

#include <fstream>
#include <random>

#include "core/base/hash.h"
#include "core/log/followed_file.h"
#include "core/log/log_profile.h"
#include "core/mcap/append_record.h"
#include "core/mcap/records.h"
#include "tests/core/log/followed_log.h"
#include "tests/core/log/write_history.h"
#include "tests/core/mcap/file_maker.h"
#include "tests/support/temporary_folder.h"

namespace rocinante::test {
namespace {

TEST(LogFollower, ReadsAClosedLogAsTheReaderDoes) {
  Bytes file;
  LogWriterOptions options;
  options.chunk_bytes = 2000;
  LogWriter writer = makeWriter(file, options);
  const ChannelId a = *writer.addChannel("/udp/1/a", "rk1", {{"source", "a"}});
  const ChannelId b = *writer.addChannel("/udp/1/b", "octets", {});
  for (int i = 0; i < 300; ++i) {
    const std::string payload = "payload " + std::to_string(i);
    ASSERT_TRUE(writer
                    .write(i % 3 == 0 ? b : a, static_cast<std::uint32_t>(i), at(50 + i / 2), i,
                           bytesOf(payload))
                    .ok());
  }
  ASSERT_TRUE(writer.close("finished").ok());
  LogReader reader = openLog(file);
  LogFollower follower = follow(file);
  std::vector<KeptMessage> messages;
  ASSERT_TRUE(drain(follower, messages));
  EXPECT_EQ(messages, readAll(reader));
  EXPECT_TRUE(follower.ended());
  EXPECT_EQ(follower.origin(), at(50));
}

TEST(LogFollower, LeavesABrokenChunkOutAndGoesOn) {
  WriteHistory history(false);
  history.addWholeChunk(2);
  const std::size_t second = history.writes().size();
  history.addWholeChunk(2);
  history.finish();
  Bytes file = history.after(second);
  // A byte of the first chunk's payload.
  const std::string_view text = textOf(file);
  file[text.find("RK1")] ^= std::byte{1};
  const Bytes whole = history.after(history.writes().size());
  file.insert(file.end(), whole.begin() + static_cast<std::ptrdiff_t>(file.size()), whole.end());
  LogFollower follower = follow(file);
  std::vector<KeptMessage> messages;
  ASSERT_TRUE(drain(follower, messages));
  EXPECT_EQ(messages.size(), 2U);
  EXPECT_TRUE(follower.ended());
  const std::vector<DamageSpan> damage = follower.takeDamage();
  ASSERT_EQ(damage.size(), 1U);
  EXPECT_THAT(damage[0].cause, testing::HasSubstr("fails its checksum"));
  EXPECT_TRUE(follower.takeDamage().empty());
}

TEST(LogFollower, SaysWhenTheFileWasMadeShorter) {
  WriteHistory history(true);
  history.beginOpenChunk();
  history.addMessages(3);
  Bytes file = history.after(history.writes().size());
  LogFollower follower = follow(file);
  std::vector<KeptMessage> messages;
  ASSERT_TRUE(drain(follower, messages));
  EXPECT_EQ(messages.size(), 3U);
  file.pop_back();
  std::string why;
  EXPECT_FALSE(drain(follower, messages, &why));
  EXPECT_EQ(why, "the file was truncated while it was followed (growing.mcap)");
  file = history.after(history.writes().size());
  EXPECT_FALSE(drain(follower, messages)) << "what it has said it says again";
}

TEST(LogFollower, BearsAWriteThatTheDiskCutShortAndThatWasTakenBack) {
  WriteHistory history(false);
  history.beginOpenChunk();
  history.addMessages(1);
  Bytes file = history.after(history.writes().size());
  LogFollower follower = follow(file);
  std::vector<KeptMessage> messages;
  const Bytes before = file;
  file.push_back(std::byte{5});  // the beginning of a message
  file.push_back(std::byte{77});
  ASSERT_TRUE(drain(follower, messages));
  file = before;
  ASSERT_TRUE(drain(follower, messages));
  history.endOpenChunk(0);
  history.finish();
  file = history.after(history.writes().size());
  ASSERT_TRUE(drain(follower, messages));
  EXPECT_EQ(messages, history.messages());
  EXPECT_TRUE(follower.ended());
  EXPECT_TRUE(follower.takeDamage().empty());
}

TEST(LogFollower, ManyBombsTogetherAreExpandedWithinABudget) {
  Bytes records;
  mcap::Chunk bomb = makeChunk(records, {{10, std::string(std::size_t{60} << 20U, '\0')}});
  Bytes small(ZSTD_compressBound(records.size()));
  small.resize(ZSTD_compress(small.data(), small.size(), records.data(), records.size(), 1));
  bomb.compression = "zstd";
  bomb.records = small;
  FileMaker file;
  constexpr std::size_t kBombs = 12;
  for (std::size_t i = 0; i < kBombs; ++i) file.add(bomb);
  Bytes last;
  const Bytes bytes = file.add(makeChunk(last, {{20, "after them"}})).end();
  LogFollower follower = follow(bytes);
  std::size_t messages = 0;
  while (true) {
    const Result<std::optional<LogMessage>> message = follower.poll();
    ASSERT_TRUE(message.ok()) << message.error().text();
    if (!*message) break;
    ++messages;
  }
  std::size_t refused = 0;
  for (const DamageSpan& span : follower.takeDamage()) {
    if (span.cause.find("is not expanded") != std::string::npos) ++refused;
  }
  EXPECT_GT(refused, 0U);
  EXPECT_EQ(messages, kBombs - refused + 1);
}

TEST(LogFollower, SaysThatAFormatIsNotKnown) {
  for (const char* format : {"1", "9"}) {
    Bytes a;
    const Bytes file =
        FileMaker("rocinante")
            .add(mcap::Metadata{"rocinante.session", {{"format", format}, {"session_id", "s"}}})
            .add(makeChunk(a, {{10, "ten"}}))
            .end();
    LogFollower follower = follow(file);
    std::vector<KeptMessage> messages;
    ASSERT_TRUE(drain(follower, messages));
    EXPECT_EQ(messages.size(), 1U);
    const std::vector<DamageSpan> damage = follower.takeDamage();
    EXPECT_EQ(damage.empty(), std::string(format) == "1");
    if (damage.empty()) continue;
    EXPECT_THAT(damage[0].cause, testing::HasSubstr("format \"9\""));
  }
}

TEST(LogFollower, RefusesWhatIsNoLog) {
  for (const std::string text : {"M", "\x89MCAP1\r\n", "not a log at all"}) {
    const Bytes file(bytesOf(text).begin(), bytesOf(text).end());
    const Result<LogFollower> follower =
        LogFollower::openOn(std::make_unique<FakeFile>(file), LogFollower::From::start);
    ASSERT_FALSE(follower.ok()) << text;
    EXPECT_EQ(follower.error().kind, ErrorKind::damaged);
  }
  EXPECT_EQ(LogFollower::open("no-such-file.mcap", LogFollower::From::now).error().kind,
            ErrorKind::not_found);
  EXPECT_EQ(LogFollower::open("/", LogFollower::From::now).error().kind, ErrorKind::unreadable);
  EXPECT_EQ(LogFollower::open("/dev/zero", LogFollower::From::now).error().kind,
            ErrorKind::unreadable);
}

TEST(LogFollower, StopsAtBytesThatAreNoRecord) {
  WriteHistory history(true);
  Bytes file = history.after(1);
  const std::size_t end = file.size();
  file.resize(end + 9);  // opcode 0
  LogFollower follower = follow(file);
  std::vector<KeptMessage> messages;
  std::string why;
  EXPECT_FALSE(drain(follower, messages, &why));
  EXPECT_THAT(why, testing::HasSubstr("byte " + std::to_string(end)));

  // A length that no file can have.
  file[end] = std::byte{0x80};
  std::fill_n(file.begin() + static_cast<std::ptrdiff_t>(end) + 1, 8, std::byte{0xFF});
  LogFollower second = follow(file);
  EXPECT_FALSE(drain(second, messages));
}

TEST(LogFollower, SaysWhenAnotherFileTookItsPlace) {
  const TemporaryFolder folder;
  WriteHistory history(false);
  history.addWholeChunk(2);
  const Bytes bytes = history.after(history.writes().size());
  const auto write = [&](const char* name) {
    std::ofstream(folder / name, std::ios::binary) << textOf(bytes);
  };
  write("a.mcap");
  Result<LogFollower> follower = LogFollower::open(folder / "a.mcap", LogFollower::From::start);
  ASSERT_TRUE(follower.ok());
  std::vector<KeptMessage> messages;
  std::string why;
  ASSERT_TRUE(drain(*follower, messages, &why)) << why;
  EXPECT_EQ(messages.size(), 2U);
  std::filesystem::remove(folder / "a.mcap");
  EXPECT_TRUE(drain(*follower, messages)) << "its recorder may go on without a name";
  write("b.mcap");
  std::filesystem::rename(folder / "b.mcap", folder / "a.mcap");
  EXPECT_FALSE(drain(*follower, messages, &why));
  EXPECT_THAT(why, testing::HasSubstr("another file replaced the one that is followed"));
}

}  // namespace
}  // namespace rocinante::test
