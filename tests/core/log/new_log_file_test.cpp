#include "core/log/new_log_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <barrier>
#include <thread>
#include <vector>

#include "core/base/atomic_file.h"
#include "tests/support/temporary_folder.h"

namespace rocinante::test {
namespace {

using ::testing::HasSubstr;

std::vector<std::string> namesIn(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& each : std::filesystem::directory_iterator(folder)) {
    names.push_back(each.path().filename().string());
  }
  return names;
}

TEST(NewLogFile, ReplacesAFileAndLeavesTheOldOneToItsReaders) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "a.mcap";
  ASSERT_TRUE(writeFileWhole(path, bytesOf("precious"), false).ok());
  const int reader = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_GE(reader, 0);
  Result<NewLogFile> file = NewLogFile::make(path, true);
  ASSERT_TRUE(file.ok()) << file.error().text();
  EXPECT_EQ(readFile(path).value(), "precious");
  const auto sink = file->takeSink();
  ASSERT_TRUE(sink->append(bytesOf("new")).ok());
  ASSERT_TRUE(file->publish().ok());
  EXPECT_TRUE(sink->check().ok());
  EXPECT_EQ(readFile(path).value(), "new");
  char old[8];
  ASSERT_EQ(::pread(reader, old, sizeof old, 0), 8);
  EXPECT_EQ(std::string_view(old, sizeof old), "precious");
  ::close(reader);
  EXPECT_EQ(namesIn(folder.path()), std::vector<std::string>{"a.mcap"});
}

TEST(NewLogFile, OneThatIsNotPublishedIsRemovedAndTheOldOneStays) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeFileWhole(folder / "a.mcap", bytesOf("precious"), false).ok());
  { ASSERT_TRUE(NewLogFile::make(folder / "a.mcap", true).ok()); }
  { ASSERT_TRUE(NewLogFile::make(folder / "b.mcap", false).ok()); }
  EXPECT_EQ(readFile(folder / "a.mcap").value(), "precious");
  EXPECT_EQ(namesIn(folder.path()), std::vector<std::string>{"a.mcap"});
}

TEST(NewLogFile, OneThatIsBeingWrittenIsRefusedToOthersForcedOrNot) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "a.mcap";
  Result<NewLogFile> file = NewLogFile::make(path, false);
  ASSERT_TRUE(file.ok());
  auto sink = file->takeSink();
  ASSERT_TRUE(file->publish().ok());
  for (const bool overwrite : {false, true}) {
    const Result<NewLogFile> second = NewLogFile::make(path, overwrite);
    ASSERT_FALSE(second.ok());
    EXPECT_EQ(second.error().kind, ErrorKind::refused);
    EXPECT_THAT(second.error().text(),
                HasSubstr(overwrite ? "is writing this file" : "already exists"));
  }
  EXPECT_TRUE(sink->check().ok());
  ASSERT_TRUE(sink->close().ok());
  EXPECT_TRUE(NewLogFile::make(path, true).ok());
}

TEST(NewLogFile, OfManyThatBeginAtOnceOneGetsIt) {
  for (const bool there : {false, true}) {
    for (const bool overwrite : {true, false}) {
      if (there && !overwrite) continue;
      const TemporaryFolder folder;
      const std::filesystem::path path = folder / "a.mcap";
      if (there) {
        ASSERT_TRUE(writeFileWhole(path, bytesOf("old"), false).ok());
      }
      constexpr std::size_t kWriters = 8;
      std::vector<std::unique_ptr<ByteSink>> sinks(kWriters);
      std::barrier together(kWriters);
      std::vector<std::thread> threads;
      for (auto& sink : sinks) {
        threads.emplace_back([&] {
          together.arrive_and_wait();
          Result<NewLogFile> file = NewLogFile::make(path, overwrite);
          if (!file) return;
          auto made = file->takeSink();
          if (file->publish()) sink = std::move(made);
        });
      }
      for (std::thread& each : threads) each.join();
      EXPECT_EQ(std::ranges::count_if(sinks, [](const auto& each) { return each != nullptr; }), 1);
      for (const auto& each : sinks) {
        if (each) {
          EXPECT_TRUE(each->check().ok());
        }
      }
    }
  }
}

TEST(NewLogFile, ALinkStaysAndItsFileIsReplaced) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeFileWhole(folder / "far.mcap", bytesOf("old"), false).ok());
  std::filesystem::create_symlink("far.mcap", folder / "a.mcap");
  Result<NewLogFile> file = NewLogFile::make(folder / "a.mcap", true);
  ASSERT_TRUE(file.ok());
  ASSERT_TRUE(file->takeSink()->close().ok());
  ASSERT_TRUE(file->publish().ok());
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "a.mcap"));
  EXPECT_EQ(readFile(folder / "far.mcap").value(), "");
}

TEST(NewLogFile, WithoutLocksItIsMadeAndSaysSo) {
  const TemporaryFolder folder;
  FileCalls calls = FileCalls::system();
  calls.lock = [](int, const std::filesystem::path&) -> Result<Lock> { return Lock::unsupported; };
  for (const bool overwrite : {false, true}) {
    Result<NewLogFile> file = NewLogFile::make(folder / "a.mcap", overwrite, calls);
    ASSERT_TRUE(file.ok()) << file.error().text();
    EXPECT_FALSE(file->locked());
    ASSERT_TRUE(file->publish().ok());
  }
}

struct WrittenFile {
  WrittenFile() : file(NewLogFile::make(path, false).value()), sink(file.takeSink()) {
    EXPECT_TRUE(file.publish().ok());
    EXPECT_TRUE(sink->append(bytesOf("0123456789")).ok());
    EXPECT_TRUE(sink->check().ok());
  }
  TemporaryFolder folder;
  std::filesystem::path path = folder / "a.mcap";
  NewLogFile file;
  std::unique_ptr<ByteSink> sink;
};

TEST(DisturbedLog, OneThatIsDeletedOrReplacedIsToldAndWrittenOn) {
  for (const bool replaced : {false, true}) {
    WrittenFile log;
    if (replaced) {
      std::filesystem::rename(log.path, log.folder / "kept");
      ASSERT_TRUE(writeFileWhole(log.path, bytesOf("another"), false).ok());
      // It has only moved.
      EXPECT_TRUE(log.sink->check().ok());
      std::filesystem::rename(log.path, log.folder / "kept");
    } else {
      std::filesystem::remove(log.path);
    }
    EXPECT_TRUE(log.sink->append(bytesOf("more")).ok());
    const Status checked = log.sink->check();
    ASSERT_FALSE(checked.ok());
    EXPECT_EQ(checked.error().kind, ErrorKind::damaged);
    EXPECT_THAT(checked.error().text(), HasSubstr("deleted or replaced"));
    EXPECT_FALSE(log.sink->close().ok());
  }
}

TEST(DisturbedLog, OneThatIsCutIsToldThoughItGrowsAgain) {
  WrittenFile log;
  ASSERT_EQ(::truncate(log.path.c_str(), 3), 0);
  EXPECT_TRUE(log.sink->append(bytesOf("more")).ok());
  const Status checked = log.sink->check();
  ASSERT_FALSE(checked.ok());
  EXPECT_THAT(checked.error().text(), HasSubstr("3 bytes where 10 were written"));
  EXPECT_FALSE(log.sink->close().ok());
}

TEST(DisturbedLog, OneThatAnotherProgramAppendsToIsTold) {
  WrittenFile log;
  const int file = ::open(log.path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  ASSERT_EQ(::write(file, "x", 1), 1);
  ::close(file);
  EXPECT_FALSE(log.sink->close().ok());
}

TEST(DisturbedLog, MovedOrLinkedItIsAsItWas) {
  WrittenFile log;
  std::filesystem::create_hard_link(log.path, log.folder / "second");
  std::filesystem::rename(log.path, log.folder / "moved.mcap");
  std::filesystem::remove(log.folder / "moved.mcap");
  EXPECT_TRUE(log.sink->check().ok());
  EXPECT_TRUE(log.sink->close().ok());
}

}  // namespace
}  // namespace rocinante::test
