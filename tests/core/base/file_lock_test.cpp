#include "core/base/file_lock.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/base/atomic_file.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using ::testing::HasSubstr;

/// A descriptor of its own, closed with the test.
struct Opened {
  explicit Opened(const std::filesystem::path& path)
      : file(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)) {
    EXPECT_GE(file, 0);
  }
  ~Opened() { ::close(file); }
  int file;
};

TEST(FileLock, ASecondWriterIsRefusedUntilTheFirstCloses) {
  const test::TemporaryFolder folder;
  const Opened second(folder / "a");
  {
    const Opened first(folder / "a");
    ASSERT_EQ(lockFile(first.file, folder / "a").value(), Lock::taken);
    const Result<Lock> refused = lockFile(second.file, folder / "a");
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().kind, ErrorKind::refused);
    EXPECT_THAT(refused.error().text(), HasSubstr("is writing this file"));
    EXPECT_EQ(refused.error().where, (folder / "a").string());
  }
  EXPECT_TRUE(lockFile(second.file, folder / "a").ok());
}

TEST(FileLock, DeathReleasesIt) {
  const test::TemporaryFolder folder;
  int locked[2];
  ASSERT_EQ(::pipe(locked), 0);
  const std::string path = (folder / "a").string();
  const pid_t child = ::fork();
  if (child == 0) {
    const int file = ::open(path.c_str(), O_RDWR | O_CREAT, 0600);
    const char done = ::flock(file, LOCK_EX) == 0 ? 'y' : 'n';
    (void)!::write(locked[1], &done, 1);
    for (;;) ::pause();
  }
  char done = 0;
  ASSERT_EQ(::read(locked[0], &done, 1), 1);
  ASSERT_EQ(done, 'y');
  EXPECT_FALSE(mayReplace(path).ok());
  ::kill(child, SIGKILL);
  ASSERT_EQ(::waitpid(child, nullptr, 0), child);
  EXPECT_TRUE(mayReplace(path).ok());
  ::close(locked[0]);
  ::close(locked[1]);
}

TEST(FileLock, NothingIsHeldWhereNoFileStands) {
  const test::TemporaryFolder folder;
  for (const std::filesystem::path& path : {folder / "none", folder.path()}) {
    const Result<HeldFile> held = HeldFile::at(path, HeldFile::For::writing);
    ASSERT_TRUE(held.ok());
    EXPECT_FALSE(held->holds());
  }
}

TEST(FileLock, WhatIsWrittenIsNotReplacedByAWholeFile) {
  const test::TemporaryFolder folder;
  const Opened writer(folder / "a");
  ASSERT_TRUE(lockFile(writer.file, folder / "a").ok());
  EXPECT_FALSE(mayWriteFile(folder / "a", true).ok());
  const Status written = writeFileWhole(folder / "a", bytesOf("x"), true);
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().kind, ErrorKind::refused);
  EXPECT_TRUE(isOpenFile(folder / "a", writer.file));
}

TEST(FileLock, WholeFilesReplaceEachOther) {
  const test::TemporaryFolder folder;
  const Opened made(folder / "a");
  const Result<HeldFile> held = HeldFile::at(folder / "a", HeldFile::For::replacing);
  ASSERT_TRUE(held.ok());
  EXPECT_TRUE(held->holds());
  EXPECT_TRUE(writeFileWhole(folder / "a", bytesOf("x"), true).ok());
}

TEST(LockHolder, IsTheOneThatLockedThisInodeAlone) {
  constexpr std::string_view kTable =
      "1: POSIX  ADVISORY  WRITE 611 fe:00:1835 0 EOF\n"
      "2: FLOCK  ADVISORY  READ 613 fe:00:1835 0 EOF\n"
      "2: -> FLOCK  ADVISORY  WRITE 614 fe:00:1835 0 EOF\n"
      "3: FLOCK  ADVISORY  WRITE 612 fe:00:1835 0 EOF\n"
      "4: FLOCK  ADVISORY  WRITE 0 fe:00:77 0 EOF\n";
  EXPECT_EQ(lockHolder(kTable, 1835), 612);
  // /proc/locks gives no pid for a process of another name space.
  EXPECT_EQ(lockHolder(kTable, 77), std::nullopt);
  EXPECT_EQ(lockHolder(kTable, 835), std::nullopt);
  EXPECT_EQ(lockHolder("", 1), std::nullopt);
}

}  // namespace
}  // namespace rocinante
