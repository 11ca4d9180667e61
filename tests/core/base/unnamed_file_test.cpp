#include "core/base/unnamed_file.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <utility>

#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

TEST(UnnamedFile, GivesBackWhatWasWrittenAndLeavesNothing) {
  const test::TemporaryFolder folder;
  {
    Result<UnnamedFile> file = UnnamedFile::make(folder.path().string());
    ASSERT_TRUE(file) << file.error().text();
    ASSERT_TRUE(file->write(5, bytesOf("world")));
    ASSERT_TRUE(file->write(0, bytesOf("hello")));
    const UnnamedFile moved = std::move(*file);
    std::array<std::byte, 8> read;
    ASSERT_TRUE(moved.read(2, read));
    EXPECT_EQ(textOf(read), "lloworld");
    EXPECT_FALSE(moved.read(3, read)) << "there is one byte less";
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(UnnamedFile, NamesTheFolderThatIsNotThere) {
  const Result<UnnamedFile> file = UnnamedFile::make("/no/such/folder");
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().text(),
            "cannot make a temporary file: No such file or directory (/no/such/folder)");
}

}  // namespace
}  // namespace rocinante
