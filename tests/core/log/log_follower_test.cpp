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
#include "tests/core/log/log_support.h"
#include "tests/core/mcap/file_maker.h"
#include "tests/support/temporary_folder.h"

namespace rocinante::test {
namespace {

/// A file that grows under the test's control.
class FakeFile final : public FollowedFile {
 public:
  explicit FakeFile(const Bytes& content) : content_(content) {}
  Result<std::uint64_t> size() override { return content_.size(); }
  Status read(std::uint64_t offset, std::span<std::byte> out) override {
    if (offset > content_.size() || out.size() > content_.size() - offset) {
      return Error{ErrorKind::unreadable, "read past the end", name_};
    }
    std::copy_n(content_.begin() + static_cast<std::ptrdiff_t>(offset), out.size(), out.begin());
    return {};
  }
  const std::string& name() const override { return name_; }

 private:
  const Bytes& content_;
  std::string name_ = "growing.mcap";
};

LogFollower follow(const Bytes& content, LogFollower::From from = LogFollower::From::start) {
  Result<LogFollower> follower = LogFollower::openOn(std::make_unique<FakeFile>(content), from);
  EXPECT_TRUE(follower.ok()) << follower.error().text();
  return std::move(*follower);
}

/// Adds everything that is there now to `messages`; false after an error.
bool drain(LogFollower& follower, std::vector<KeptMessage>& messages, std::string* why = nullptr) {
  while (true) {
    const Result<std::optional<LogMessage>> message = follower.poll();
    if (!message.ok()) {
      if (why != nullptr) *why = message.error().text();
      return false;
    }
    if (!*message) return true;
    messages.push_back(keep(**message));
  }
}

/// A recorder's change to a file, write by write.
class History {
 public:
  struct Write {
    std::optional<std::size_t> offset;  ///< empty: at the end
    Bytes bytes;
    std::size_t messages = 0;  ///< that must be read once it is done
  };

  explicit History(bool compressed) : compressed_(compressed) {
    Bytes begin(mcap::magic().begin(), mcap::magic().end());
    mcap::append(begin, mcap::Header{std::string(profile::kName), "test"});
    mcap::Metadata session;
    session.name = profile::kSession;
    session.metadata = {{"format", "1"}, {"session_id", "s"}, {"origin_ns", "1000"}};
    mcap::append(begin, session);
    append(std::move(begin));
  }
  ~History() { ZSTD_freeCCtx(zstd_); }
  History(const History&) = delete;
  History& operator=(const History&) = delete;

  void beginOpenChunk() {
    records_.clear();
    chunk_offset_ = size_;
    Bytes whole;
    mcap::append(whole, chunk());
    Bytes begin(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(headBytes()));
    // Length, end time, size, checksum, length of the records: docs/log-format.md.
    std::fill_n(begin.begin() + 1, 8, std::byte{0xFF});
    std::fill_n(begin.begin() + 17, 16, std::byte{0xFF});
    std::fill_n(begin.begin() + 33, 4, std::byte{0});
    std::fill_n(begin.end() - 8, 8, std::byte{0xFF});
    append(std::move(begin));
    ZSTD_CCtx_reset(zstd_, ZSTD_reset_session_only);
    stored_.clear();
  }
  void addMessages(int count) {
    append(pieceOf(count, ZSTD_e_flush));
    writes_.back().messages = messages_.size();
  }
  void endOpenChunk(int count) {
    Bytes rest = pieceOf(count, ZSTD_e_end);
    if (!rest.empty()) {
      append(std::move(rest));
      writes_.back().messages = messages_.size();
    }
    Bytes whole;
    mcap::append(whole, chunk());
    whole.resize(headBytes());
    writes_.push_back({chunk_offset_, std::move(whole), messages_.size()});
    appendIndexes();
  }
  void addWholeChunk(int count) {
    records_.clear();
    ZSTD_CCtx_reset(zstd_, ZSTD_reset_session_only);
    stored_.clear();
    (void)pieceOf(count, ZSTD_e_end);
    Bytes whole;
    mcap::append(whole, chunk());
    append(std::move(whole));
    writes_.back().messages = messages_.size();
    appendIndexes();
  }
  void addAttachment() {
    Bytes bytes;
    const std::string data(200, 'a');
    mcap::Attachment attachment;
    attachment.name = "cell.toml";
    attachment.data = bytesOf(data);
    mcap::append(bytes, attachment);
    append(std::move(bytes));
  }
  void finish() {
    Bytes end;
    mcap::append(end, mcap::Metadata{std::string(profile::kEnd), {{"reason", "stopped"}}});
    mcap::append(end, mcap::DataEnd{0});
    mcap::append(end, mcap::Statistics{});
    mcap::append(end, mcap::Footer{});
    end.insert(end.end(), mcap::magic().begin(), mcap::magic().end());
    append(std::move(end));
  }

  const std::vector<Write>& writes() const { return writes_; }
  const std::vector<KeptMessage>& messages() const { return messages_; }

  /// The file after the first `count` writes.
  Bytes after(std::size_t count) const {
    Bytes file;
    for (std::size_t i = 0; i < count; ++i) apply(file, writes_[i]);
    return file;
  }
  static void apply(Bytes& file, const Write& write) {
    const std::size_t offset = write.offset.value_or(file.size());
    file.resize(std::max(file.size(), offset + write.bytes.size()));
    std::copy(write.bytes.begin(), write.bytes.end(),
              file.begin() + static_cast<std::ptrdiff_t>(offset));
  }

 private:
  void append(Bytes bytes) {
    size_ += bytes.size();
    writes_.push_back({std::nullopt, std::move(bytes), messages_.size()});
  }
  void appendIndexes() {
    Bytes bytes;
    mcap::append(bytes, mcap::MessageIndex{7, {{1, 2}}});
    append(std::move(bytes));
  }
  std::size_t headBytes() const { return 9 + 8 + 8 + 8 + 4 + 4 + (compressed_ ? 4 : 0) + 8; }
  mcap::Chunk chunk() const {
    mcap::Chunk chunk;
    chunk.message_start_time = 1000;
    chunk.message_end_time = 5000;
    chunk.uncompressed_size = records_.size();
    chunk.uncompressed_crc = crc32(records_);
    chunk.compression = compressed_ ? "zstd" : "";
    chunk.records = stored_;
    return chunk;
  }
  /// `count` more messages of the chunk, as stored.
  Bytes pieceOf(int count, ZSTD_EndDirective how) {
    Bytes plain;
    if (records_.empty()) mcap::append(plain, mcap::Channel{7, 0, "/udp/1/arm", "rk1", {}});
    for (int i = 0; i < count; ++i) {
      const auto n = static_cast<std::uint32_t>(messages_.size());
      // Their bytes look like records: only their length tells them apart.
      const std::string payload = "RK1 arm " + std::to_string(n) + " -\n" +
                                  std::string(n * 7 % 40, n % 2 == 0 ? '\x05' : '\x07');
      mcap::append(plain, mcap::Message{7, n, 1000 + n, 900 + n, bytesOf(payload)});
      messages_.push_back({"/udp/1/arm", n, 1000 + n, 900 + n, payload});
    }
    records_.insert(records_.end(), plain.begin(), plain.end());
    Bytes piece = plain;
    if (compressed_) {
      piece.resize(ZSTD_compressBound(plain.size()) + 64);
      ZSTD_inBuffer in{plain.data(), plain.size(), 0};
      ZSTD_outBuffer out{piece.data(), piece.size(), 0};
      EXPECT_EQ(ZSTD_compressStream2(zstd_, &out, &in, how), 0U);
      piece.resize(out.pos);
    }
    stored_.insert(stored_.end(), piece.begin(), piece.end());
    return piece;
  }

  bool compressed_;
  ZSTD_CCtx* zstd_ = ZSTD_createCCtx();
  std::vector<Write> writes_;
  std::vector<KeptMessage> messages_;
  std::size_t size_ = 0;
  std::size_t chunk_offset_ = 0;
  Bytes records_;
  Bytes stored_;
};

void record(History& history) {
  history.beginOpenChunk();
  history.addMessages(1);
  history.addMessages(5);
  history.addMessages(2);
  history.endOpenChunk(3);
  history.addAttachment();
  history.addWholeChunk(4);
  history.beginOpenChunk();
  history.addMessages(3);
  history.endOpenChunk(0);
  history.finish();
}

class LogFollowerOfAGrowingFile : public testing::TestWithParam<bool> {};

TEST_P(LogFollowerOfAGrowingFile, GivesEveryMessageAsSoonAsItIsWholeAndNeverHalfOfOne) {
  History history(GetParam());
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
  for (const History::Write& write : history.writes()) {
    ASSERT_FALSE(follower.ended());
    if (write.offset) {
      // Torn between two pages of memory, at every place.
      const Bytes before = file;
      for (std::size_t part = 1; part < write.bytes.size(); ++part) {
        file = before;
        History::apply(file, {write.offset, cutAt(write.bytes, part)});
        look();
      }
      History::apply(file, write);
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
  History history(GetParam());
  record(history);
  for (std::size_t done = 0; done <= history.writes().size(); ++done) {
    const Bytes first = history.after(done);
    const std::size_t last_bytes = done == 0 || history.writes()[done - 1].offset
                                       ? 0
                                       : history.writes()[done - 1].bytes.size();
    for (std::size_t missing = 0; missing <= last_bytes; ++missing) {
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
        History::apply(file, history.writes()[i]);
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
  History history(GetParam());
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
    for (History::Write write : history.writes()) {
      if (write.offset) write.bytes[wrong] ^= std::byte{1};
      History::apply(file, write);
      ASSERT_TRUE(drain(follower, messages));
    }
    EXPECT_EQ(messages.size(), 3U);
    EXPECT_TRUE(follower.ended());
    const std::vector<DamageSpan> damage = follower.takeDamage();
    ASSERT_EQ(damage.size(), 1U);
    EXPECT_THAT(damage[0].cause, testing::HasSubstr("does not match what was read"));
  }
}

TEST_P(LogFollowerOfAGrowingFile, BearsEveryFlippedBit) {
  History history(GetParam());
  record(history);
  const Bytes whole = history.after(history.writes().size());
  for (std::size_t bit = 0; bit < whole.size() * 8; bit += 3) {
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
  History history(false);
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
  History history(true);
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
  History history(false);
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
  History history(true);
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
  History history(false);
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
