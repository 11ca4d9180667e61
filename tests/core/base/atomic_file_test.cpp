#include "core/base/atomic_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

std::size_t filesIn(const std::filesystem::path& folder) {
  const auto files = std::filesystem::directory_iterator(folder);
  return static_cast<std::size_t>(std::distance(begin(files), end(files)));
}

TEST(WriteFileWhole, WhatIsWrittenIsReadBack) {
  const test::TemporaryFolder folder;
  const std::string text("text\0with a nul", 15);
  ASSERT_TRUE(writeFileWhole(folder / "a", bytesOf(text), false).ok());
  EXPECT_EQ(readFile(folder / "a").value(), text);
  ASSERT_TRUE(writeFileWhole(folder / "a", bytesOf(""), true).ok());
  EXPECT_EQ(readFile(folder / "a").value(), "");
  EXPECT_EQ(filesIn(folder.path()), 1U);
}

TEST(ReadFileInParts, HandsOverAllOfItInOrder) {
  const test::TemporaryFolder folder;
  std::string text;
  for (int i = 0; text.size() < 600'000; ++i) text += std::to_string(i);
  ASSERT_TRUE(writeFileWhole(folder / "a", bytesOf(text), false).ok());
  std::string read;
  ASSERT_TRUE(readFileInParts(folder / "a", text.size(), [&](ByteView part, std::uint64_t size) {
                EXPECT_EQ(size, text.size());
                EXPECT_LE(part.size(), std::size_t{256} << 10);
                read += textOf(part);
                return Status{};
              }).ok());
  EXPECT_EQ(read, text);
}

TEST(ReadFileInParts, StopsAtTheFirstRefusal) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(writeFileWhole(folder / "a", Bytes(600'000), false).ok());
  int parts = 0;
  const Status read =
      readFileInParts(folder / "a", 1 << 20, [&](ByteView, std::uint64_t) -> Status {
        ++parts;
        return Error{ErrorKind::refused, "enough", {}};
      });
  EXPECT_EQ(read.error().text(), "enough");
  EXPECT_EQ(parts, 1);
}

TEST(WriteFileWhole, LeavesAnExistingFileAlone) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(writeFileWhole(folder / "a", bytesOf("first"), false).ok());
  const Status second = writeFileWhole(folder / "a", bytesOf("second"), false);
  ASSERT_FALSE(second.ok());
  EXPECT_EQ(second.error().kind, ErrorKind::refused);
  EXPECT_EQ(readFile(folder / "a").value(), "first");
}

TEST(WriteFileWhole, AMissingFolderIsNamedAndNothingIsLeft) {
  const test::TemporaryFolder folder;
  const Status written = writeFileWhole(folder / "none" / "a", bytesOf("x"), false);
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().text(),
            "cannot create: No such file or directory (" + (folder / "none" / "a").string() + ")");
  EXPECT_EQ(filesIn(folder.path()), 0U);
}

TEST(WriteFileWhole, ManyFilesAreWholeBeforeTheyAreSyncedTogether) {
  const test::TemporaryFolder folder;
  for (const char* name : {"a", "b"}) {
    ASSERT_TRUE(writeFileWhole(folder / name, bytesOf("whole"), false, Sync::later).ok());
    EXPECT_EQ(readFile(folder / name).value(), "whole");
  }
  EXPECT_EQ(filesIn(folder.path()), 2U);
  EXPECT_TRUE(syncFileSystem(folder.path()).ok());
  EXPECT_EQ(syncFileSystem(folder / "none").error().kind, ErrorKind::not_found);
}

TEST(ReadFile, RefusesWhatIsTooLargeBeforeReadingIt) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(writeFileWhole(folder / "a", bytesOf("0123456789"), false).ok());
  EXPECT_EQ(readFile(folder / "a", 10).value(), "0123456789");
  EXPECT_EQ(readFile(folder / "a", 9).error().kind, ErrorKind::unsupported);
  // Endless, and reports no size.
  EXPECT_EQ(readFile("/dev/zero", 1 << 20).error().kind, ErrorKind::unsupported);
}

TEST(ReadFile, AFolderAndAMissingFileAreTold) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(readFile(folder.path()).error().text(),
            "this is a folder, not a file (" + folder.path().string() + ")");
  EXPECT_EQ(readFile(folder / "none").error().kind, ErrorKind::not_found);
}

}  // namespace
}  // namespace rocinante
