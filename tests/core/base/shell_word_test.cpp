#include <gtest/gtest.h>

#include "core/base/plain_text.h"

namespace rocinante {
namespace {

TEST(ShellWord, QuotesOnlyWhatAShellWouldTakeApart) {
  EXPECT_EQ(shellWord("--at=1.5s"), "--at=1.5s");
  EXPECT_EQ(shellWord(""), "''");
  EXPECT_EQ(shellWord("a b"), "'a b'");
  EXPECT_EQ(shellWord("it's"), "'it'\\''s'");
  EXPECT_EQ(shellWord("$(rm *)"), "'$(rm *)'");
}

}  // namespace
}  // namespace rocinante
