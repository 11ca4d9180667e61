#include "core/mcap/file_sink.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "core/base/atomic_file.h"
#include "tests/support/temporary_folder.h"

namespace rocinante::test {
namespace {

using ::testing::HasSubstr;

struct SinkFile {
  explicit SinkFile(const FileCalls& calls = FileCalls::system()) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
    EXPECT_GE(file, 0);
    sink = makeFileSinkOn(file, "disk", calls);
  }
  std::string text() const { return *readFile(path); }
  std::uint64_t allocatedBytes() const {
    struct stat status {};
    EXPECT_EQ(::stat(path.c_str(), &status), 0);
    return static_cast<std::uint64_t>(status.st_blocks) * 512;
  }

  TemporaryFolder folder;
  std::filesystem::path path = folder / "a.mcap";
  std::unique_ptr<ByteSink> sink;
};

/// Interrupted at every other call; otherwise writes at most three bytes.
FileCalls stutteringCalls() {
  FileCalls calls = FileCalls::system();
  calls.pwrite = [count = 0](int file, const void* bytes, std::size_t size,
                             off_t offset) mutable -> ssize_t {
    if (++count % 2 == 1) {
      errno = EINTR;
      return -1;
    }
    return ::pwrite(file, bytes, std::min<std::size_t>(size, 3), offset);
  };
  return calls;
}

TEST(FileSink, GoesOnAfterInterruptionsAndShortWrites) {
  SinkFile file(stutteringCalls());
  ASSERT_TRUE(file.sink->append(bytesOf("0123456789")).ok());
  ASSERT_TRUE(file.sink->overwriteAt(2, bytesOf("abcdefg")).ok());
  ASSERT_TRUE(file.sink->append(bytesOf("!")).ok());
  ASSERT_TRUE(file.sink->close().ok());
  EXPECT_EQ(file.text(), "01abcdefg9!");
}

TEST(FileSink, FailsWithTheSystemsReason) {
  FileCalls calls = FileCalls::system();
  calls.pwrite = [](int, const void*, std::size_t, off_t) -> ssize_t {
    errno = EIO;
    return -1;
  };
  SinkFile file(calls);
  EXPECT_EQ(file.sink->append(bytesOf("x")).error().text(),
            "cannot write to the file: Input/output error (disk)");
  EXPECT_EQ(file.sink->overwriteAt(0, bytesOf("x")).error().text(),
            "cannot write to the file: Input/output error (disk)");
}

TEST(FileSink, AWriteOfNothingIsAFullDisk) {
  FileCalls calls = FileCalls::system();
  calls.pwrite = [](int, const void*, std::size_t, off_t) -> ssize_t { return 0; };
  SinkFile file(calls);
  EXPECT_EQ(file.sink->append(bytesOf("x")).error().text(),
            "cannot write to the file: No space left on device (disk)");
}

TEST(FileSink, AFailedWritebackSyncOrCloseIsAnswered) {
  for (const char* call : {"writeback", "sync", "close", "cut"}) {
    SCOPED_TRACE(call);
    FileCalls calls = FileCalls::system();
    const auto broken = [] {
      errno = EIO;
      return -1;
    };
    const std::string name = call;
    if (name == "writeback") {
      calls.sync_file_range = [&](int, off_t, off_t, unsigned) { return broken(); };
    } else if (name == "sync") {
      calls.fdatasync = [&](int) { return broken(); };
    } else if (name == "close") {
      calls.close = [&](int file) {
        ::close(file);
        return broken();
      };
    } else {
      calls.ftruncate = [&](int, off_t) { return broken(); };
    }
    SinkFile file(calls);
    ASSERT_TRUE(file.sink->reserve(100'000).ok());
    ASSERT_TRUE(file.sink->append(bytesOf("x")).ok());
    const bool written_back = file.sink->startWriteback(0, 1).ok();
    EXPECT_EQ(written_back, name != "writeback");
    const Status closed = file.sink->close();
    EXPECT_EQ(closed.ok(), name == "writeback");
    if (!closed) {
      EXPECT_THAT(closed.error().text(), HasSubstr("Input/output error (disk)"));
    }
  }
}

TEST(FileSink, WhatWasReservedAndNotUsedIsGivenBack) {
  SinkFile file;
  ASSERT_TRUE(file.sink->append(bytesOf("0123456789")).ok());
  ASSERT_TRUE(file.sink->reserve(1U << 20U).ok());
  EXPECT_EQ(std::filesystem::file_size(file.path), 10U) << "a reader sees nothing of it";
  if (file.allocatedBytes() < 1U << 20U) GTEST_SKIP() << "no preallocation on this file system";
  ASSERT_TRUE(file.sink->close().ok());
  EXPECT_LT(file.allocatedBytes(), 1U << 16U);
  EXPECT_EQ(file.text(), "0123456789");
}

TEST(FileSink, WithoutPreallocationReservingIsNothing) {
  for (const int reason : {EOPNOTSUPP, ENOSYS}) {
    FileCalls calls = FileCalls::system();
    int asked = 0;
    calls.fallocate = [&](int, int, off_t, off_t) {
      ++asked;
      errno = reason;
      return -1;
    };
    SinkFile file(calls);
    EXPECT_TRUE(file.sink->reserve(1000).ok());
    EXPECT_TRUE(file.sink->reserve(2000).ok());
    EXPECT_EQ(asked, 1);
  }
}

TEST(FileSink, RoomThatIsNotThereIsSaidBeforeAnythingIsWritten) {
  FileCalls calls = FileCalls::system();
  calls.fallocate = [](int, int, off_t, off_t) {
    errno = ENOSPC;
    return -1;
  };
  SinkFile file(calls);
  EXPECT_EQ(file.sink->reserve(1000).error().text(),
            "cannot write to the file: No space left on device (disk)");
}

TEST(FileSink, TheLimitOnFileSizesCountsAsFull) {
  struct rlimit before {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  struct rlimit limit = before;
  limit.rlim_cur = 5000;
  SinkFile file;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
  const Status fits = file.sink->reserve(5000);
  const Status beyond = file.sink->reserve(5001);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  EXPECT_TRUE(fits.ok());
  ASSERT_FALSE(beyond.ok());
  EXPECT_THAT(beyond.error().text(), HasSubstr("File too large"));
}

TEST(FileSink, APipeIsOnlyAppendedTo) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const auto sink = makeFileSinkOn(ends[1], "pipe");
  EXPECT_FALSE(sink->overwritable());
  EXPECT_TRUE(sink->reserve(1000).ok());
  EXPECT_TRUE(sink->append(bytesOf("abc")).ok());
  EXPECT_TRUE(sink->startWriteback(0, 3).ok());
  EXPECT_TRUE(sink->close().ok());
  char text[4] = {};
  EXPECT_EQ(::read(ends[0], text, sizeof text), 3);
  EXPECT_STREQ(text, "abc");
  ::close(ends[0]);
}

}  // namespace
}  // namespace rocinante::test
