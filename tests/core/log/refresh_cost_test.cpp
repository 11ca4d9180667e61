// What a refresh of a growing log costs, counted in memory that it asks for: in a program alone,
// because it counts every `new`.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <new>

#include "core/log/log_reader.h"
#include "core/log/log_writer.h"
#include "core/mcap/record_stepper.h"
#include "tests/support/temporary_folder.h"

namespace {

std::uint64_t g_bytes = 0;

}  // namespace

// Not inlined: where g++ sees malloc() inside `new`, it takes the two for a mismatch.
[[gnu::noinline]] void* operator new(std::size_t size) {
  void* const block = std::malloc(size == 0 ? 1 : size);
  if (block == nullptr) std::abort();
  g_bytes += size;
  return block;
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return operator new(size);
}
[[gnu::noinline]] void operator delete(void* block) noexcept { std::free(block); }
[[gnu::noinline]] void operator delete(void* block, std::size_t) noexcept { std::free(block); }

namespace rocinante::test {
namespace {

/// Makes what begins the second chunk of a log no record.
void breakSecondChunk(const std::filesystem::path& path) {
  std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
  std::string bytes((std::istreambuf_iterator<char>(file)), {});
  mcap::RecordStepper steps(bytesOf(bytes), mcap::magic().size());
  int chunks = 0;
  while (const auto record = steps.next()) {
    if (record->opcode != mcap::Opcode::chunk || ++chunks < 2) continue;
    file.clear();
    file.seekp(static_cast<std::streamoff>(record->offset));
    file.write(std::string(9, '\0').data(), 9);
    return;
  }
  FAIL() << "no second chunk";
}

/// A log of this many chunks: the least bytes that one of some refreshes asks for, each after a few
/// messages more. Now and then a list grows to twice its size; the least is one without that.
std::uint64_t refreshCost(std::size_t chunks, bool is_broken = false) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "log.mcap";
  Result<LogWriter> writer = LogWriter::create(path, {.chunk_bytes = 400}, "s");
  if (!writer) return 0;
  const ChannelId arm = *writer->addChannel("/udp/1/arm", "rk1", {});
  const ChannelId own = *writer->addChannel("/rocinante/loss", "json", {});
  std::uint32_t count = 0;
  const auto add = [&](int messages) {
    for (; messages > 0; --messages, ++count) {
      const LogTime time{Nanoseconds(1000 + count)};
      const ChannelId channel = count % 50 == 0 ? own : arm;
      EXPECT_TRUE(writer->write(channel, count, time, 0, bytesOf("RK1 arm - -\n")).ok());
    }
    EXPECT_TRUE(writer->flush().ok());
  };
  if (is_broken) {
    add(200);
    breakSecondChunk(path);
  }
  Result<LogReader> reader = LogReader::openGrowing(path);
  EXPECT_TRUE(reader.ok());
  while (reader->storage().chunks < chunks) {
    add(100);
    EXPECT_TRUE(*reader->refresh());
  }
  std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
  for (int look = 0; look < 40; ++look) {
    add(3);
    const std::uint64_t before = g_bytes;
    EXPECT_TRUE(*reader->refresh());
    // What a window does with it.
    const LogTime end = reader->summary().end;
    (void)reader->inOrderAt({end, 0});
    EXPECT_TRUE(reader->seek(end).ok());
    EXPECT_TRUE(reader->next().ok());
    least = std::min(least, g_bytes - before);
  }
  EXPECT_EQ(reader->damage().empty(), !is_broken);
  const std::uint64_t captured = count - (count + 49) / 50;
  EXPECT_EQ(reader->summary().messages < captured, is_broken);
  return least;
}

TEST(RefreshCost, IsThatOfWhatIsNewHoweverLongTheLogIs) {
  const std::uint64_t after_an_hour = refreshCost(50);
  const std::uint64_t after_a_day = refreshCost(1200);
  EXPECT_GT(after_an_hour, 0U);
  EXPECT_LT(after_a_day, after_an_hour + 1200 * sizeof(std::uint32_t));
}

TEST(RefreshCost, BehindDamageIsThatOfWhatIsNewToo) {
  const std::uint64_t after_an_hour = refreshCost(50, true);
  const std::uint64_t after_a_day = refreshCost(1200, true);
  EXPECT_GT(after_an_hour, 0U);
  EXPECT_LT(after_a_day, after_an_hour + 1200 * sizeof(std::uint32_t));
}

}  // namespace
}  // namespace rocinante::test
