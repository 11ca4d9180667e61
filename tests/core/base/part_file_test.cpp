#include "core/base/part_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <barrier>
#include <fstream>
#include <thread>
#include <vector>

#include "core/base/atomic_file.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using ::testing::MatchesRegex;
using ::testing::SizeIs;
using ::testing::UnorderedElementsAre;

std::vector<std::string> namesIn(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& each : std::filesystem::directory_iterator(folder)) {
    names.push_back(each.path().filename().string());
  }
  return names;
}

void touch(const std::filesystem::path& path) { std::ofstream(path) << "left"; }

TEST(PartFile, LiesBesideItsOutputUntilItIsPublished) {
  const test::TemporaryFolder folder;
  {
    Result<PartFile> part = PartFile::make(folder / "a.png");
    ASSERT_TRUE(part.ok()) << part.error().text();
    EXPECT_THAT(part->beside().string(), MatchesRegex(".*/a\\.png\\.part~[a-z0-9]{6}"));
    EXPECT_THAT(namesIn(folder.path()), SizeIs(1));
  }
  EXPECT_THAT(namesIn(folder.path()), SizeIs(0));
  Result<PartFile> part = PartFile::make(folder / "a.png");
  ASSERT_TRUE(part->publish(false).ok());
  EXPECT_THAT(namesIn(folder.path()), UnorderedElementsAre("a.png"));
}

TEST(PartFile, LeftoversOfItsOutputAreRemovedAndNothingElse) {
  const test::TemporaryFolder folder;
  // Neither of the same output, or not of its form; or a file of a program that still runs.
  touch(folder / "a.png.part~abc123");
  touch(folder / "a.png.part~zzzzzz");
  touch(folder / "b.png.part~abc123");
  touch(folder / "a.png.part~abc12");
  touch(folder / "a.png.part~ABCDEF");
  touch(folder / "a.png.part17");
  touch(folder / "a.png");
  std::filesystem::create_directory(folder / "a.png.part~folder");
  std::filesystem::create_symlink("a.png", folder / "a.png.part~linked");
  const int running = ::open((folder / "a.png.part~zzzzzz").c_str(), O_RDWR | O_CLOEXEC);
  ASSERT_EQ(lockFile(running, "").value(), Lock::taken);
  ASSERT_TRUE(writeFileWhole(folder / "a.png", bytesOf("new"), true).ok());
  EXPECT_THAT(namesIn(folder.path()),
              UnorderedElementsAre("a.png.part~zzzzzz", "b.png.part~abc123", "a.png.part~abc12",
                                   "a.png.part~ABCDEF", "a.png.part17", "a.png",
                                   "a.png.part~folder", "a.png.part~linked"));
  ::close(running);
}

/// As in a container: the killed process has the number that the next one has.
TEST(PartFile, AKilledWriterIsNotInTheWayOfTheNext) {
  const test::TemporaryFolder folder;
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    auto part = PartFile::make(folder / "a.png");
    (void)!::write(ready[1], "x", 1);
    ::pause();
  }
  char byte = 0;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  EXPECT_THAT(namesIn(folder.path()), SizeIs(1));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_THAT(namesIn(folder.path()), SizeIs(1));
  ASSERT_TRUE(writeFileWhole(folder / "a.png", bytesOf("new"), false).ok());
  EXPECT_THAT(namesIn(folder.path()), UnorderedElementsAre("a.png"));
  ::close(ready[0]);
  ::close(ready[1]);
}

TEST(PartFile, ALongNameIsTakenOrRefusedAtOnce) {
  const test::TemporaryFolder folder;
  for (std::size_t bytes = 238; bytes <= 255; ++bytes) {
    const std::string name = std::string(bytes - 5, 'n') + ".mcap";
    ASSERT_TRUE(writeFileWhole(folder / name, bytesOf("x"), false).ok()) << bytes;
    EXPECT_EQ(readFile(folder / name).value(), "x");
  }
  EXPECT_THAT(namesIn(folder.path()), SizeIs(18));
  const std::filesystem::path too_long = folder / std::string(256, 'n');
  EXPECT_EQ(mayWriteFile(too_long, false).error().text(),
            "cannot create: File name too long (" + too_long.string() + ")");
  EXPECT_EQ(PartFile::make(too_long).error().text(), mayWriteFile(too_long, false).error().text());
}

TEST(PartFile, ALongNameIsNotCutWithinACharacter) {
  std::string name;
  while (name.size() < 252) name += "\xc3\xa9";
  name += "xyz";
  const std::string part = partPath("/f/" + name, "abcdef").filename().string();
  EXPECT_LE(part.size(), 255U);
  EXPECT_EQ(part.find(".part~abcdef") % 2, 0U);
}

TEST(PartFile, OfManyThatMayNotOverwriteOneIsPublished) {
  for (int turn = 0; turn < 20; ++turn) {
    const test::TemporaryFolder folder;
    constexpr int kWriters = 8;
    std::barrier together(kWriters);
    std::atomic<int> published = 0;
    std::vector<std::thread> threads;
    for (int i = 0; i < kWriters; ++i) {
      threads.emplace_back([&, i] {
        Result<PartFile> part = PartFile::make(folder / "a.png");
        ASSERT_TRUE(part.ok()) << part.error().text();
        const Result<int> file = part->writer();
        ASSERT_EQ(::write(*file, &i, sizeof i), ssize_t{sizeof i});
        ::close(*file);
        together.arrive_and_wait();
        const Status done = part->publish(false);
        if (done) {
          ++published;
        } else {
          EXPECT_EQ(done.error().text(),
                    "the file exists; --force overwrites it (" + (folder / "a.png").string() + ")");
        }
      });
    }
    for (std::thread& each : threads) each.join();
    EXPECT_EQ(published, 1);
    EXPECT_THAT(namesIn(folder.path()), UnorderedElementsAre("a.png"));
  }
}

TEST(PartFile, ManyOfOneOutputDoNotRemoveEachOther) {
  const test::TemporaryFolder folder;
  std::vector<pid_t> children;
  for (int i = 0; i < 4; ++i) {
    const pid_t child = ::fork();
    if (child == 0) {
      for (int turn = 0; turn < 100; ++turn) {
        if (!writeFileWhole(folder / "a", bytesOf("x"), true, Sync::later).ok()) ::_exit(1);
      }
      ::_exit(0);
    }
    children.push_back(child);
  }
  for (const pid_t child : children) {
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_THAT(namesIn(folder.path()), UnorderedElementsAre("a"));
}

TEST(PartFile, APublishedFileIsReplacedThoughItsMakerHasNotClosedIt) {
  const test::TemporaryFolder folder;
  Result<PartFile> first = PartFile::make(folder / "a");
  ASSERT_TRUE(first.ok());
  ASSERT_TRUE(first->publish(false).ok());
  EXPECT_TRUE(writeFileWhole(folder / "a", bytesOf("x"), true, Sync::later).ok());
}

TEST(PartFile, ALinkToNothingIsRefusedAtOnce) {
  const test::TemporaryFolder folder;
  std::filesystem::create_symlink("nowhere", folder / "a");
  EXPECT_EQ(mayWriteFile(folder / "a", false).error().kind, ErrorKind::refused);
  EXPECT_TRUE(mayWriteFile(folder / "a", true).ok());
}

TEST(PartFile, AFolderReplacesAnEmptyOneOnly) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder / "full" / "of");
  for (const char* name : {"new", "full"}) {
    Result<PartFile> part = PartFile::makeFolder(folder / name);
    ASSERT_TRUE(part.ok()) << part.error().text();
    touch(part->beside() / "file");
    EXPECT_EQ(part->publish(false).ok(), std::string_view(name) == "new");
  }
  EXPECT_THAT(namesIn(folder.path()), UnorderedElementsAre("new", "full"));
  EXPECT_TRUE(std::filesystem::exists(folder / "new" / "file"));
}

}  // namespace
}  // namespace rocinante
