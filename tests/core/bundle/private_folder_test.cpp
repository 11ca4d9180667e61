#include "core/bundle/private_folder.h"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/stat.h>

#include <fstream>
#include <optional>

#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

class PrivateFolderTest : public testing::Test {
 protected:
  PrivateFolderTest() {
    const char* before = ::getenv("TMPDIR");
    if (before != nullptr) before_ = before;
    ::setenv("TMPDIR", temporary_.path().c_str(), 1);
  }
  ~PrivateFolderTest() override {
    if (before_) {
      ::setenv("TMPDIR", before_->c_str(), 1);
    } else {
      ::unsetenv("TMPDIR");
    }
  }
  std::size_t folders() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(temporary_.path()), fs::directory_iterator()));
  }

  test::TemporaryFolder temporary_;
  std::optional<std::string> before_;
};

TEST_F(PrivateFolderTest, IsItsOwnersAloneAndGoesWithAllThatIsInIt) {
  {
    const auto folder = PrivateFolder::make();
    ASSERT_TRUE(folder.ok()) << folder.error().text();
    struct stat facts {};
    ASSERT_EQ(::stat((*folder)->path().c_str(), &facts), 0);
    EXPECT_EQ(facts.st_mode & 0777U, 0700U);
    fs::create_directories((*folder)->path() / "a/b");
    std::ofstream((*folder)->path() / "a/b/c") << "x";
    EXPECT_EQ(folders(), 1U);
  }
  EXPECT_EQ(folders(), 0U);
}

TEST_F(PrivateFolderTest, OneInUseOrYoungIsLeftAlone) {
  const auto first = PrivateFolder::make();
  ASSERT_TRUE(first.ok());
  // Like a process that made its folder and ended before locking it.
  fs::create_directory(temporary_ / "rocinante-cell-young");
  std::ofstream(temporary_ / "rocinante-cell-young/.lock") << "";
  const auto second = PrivateFolder::make();
  ASSERT_TRUE(second.ok());
  EXPECT_EQ(folders(), 3U);
}

TEST_F(PrivateFolderTest, WhatAKilledProcessLeftBehindIsRemoved) {
  const auto old = fs::file_time_type::clock::now() - std::chrono::minutes(5);
  const auto in_use = PrivateFolder::make();
  ASSERT_TRUE(in_use.ok());
  fs::last_write_time((*in_use)->path(), old);
  fs::create_directories(temporary_ / "rocinante-cell-killed/a");
  std::ofstream(temporary_ / "rocinante-cell-killed/.lock") << "";
  fs::last_write_time(temporary_ / "rocinante-cell-killed", old);
  // A folder without a lock, a link, and another name are not abandoned folders.
  fs::create_directory(temporary_ / "rocinante-cell-other");
  fs::last_write_time(temporary_ / "rocinante-cell-other", old);
  fs::create_directory_symlink(temporary_ / "rocinante-cell-other",
                               temporary_ / "rocinante-cell-link");
  fs::create_directory(temporary_ / "mine");
  const auto next = PrivateFolder::make();
  ASSERT_TRUE(next.ok());
  EXPECT_FALSE(fs::exists(temporary_ / "rocinante-cell-killed"));
  EXPECT_TRUE(fs::exists((*in_use)->path()));
  EXPECT_EQ(folders(), 5U);
}

TEST_F(PrivateFolderTest, WithoutATemporaryFolderItIsRefused) {
  ::setenv("TMPDIR", (temporary_ / "gone").c_str(), 1);
  const auto folder = PrivateFolder::make();
  ASSERT_FALSE(folder.ok());
  EXPECT_EQ(folder.error().kind, ErrorKind::refused);
}

}  // namespace
}  // namespace rocinante
