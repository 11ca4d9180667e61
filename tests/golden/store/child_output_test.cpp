#include "golden/store/child_output.h"

#include <gtest/gtest.h>

#include <chrono>

namespace rocinante {
namespace {

TEST(ChildOutput, IsTakenWholeWithItsErrorsAndExit) {
  const auto child = childOutput({"sh", "-c", "printf out; printf 'err \n' >&2; exit 3"});
  ASSERT_TRUE(child.ok()) << child.error().text();
  EXPECT_EQ(child->out, "out");
  EXPECT_EQ(child->err, "err");
  EXPECT_EQ(child->exit_code, 3);
  const auto killed = childOutput({"sh", "-c", "kill -9 $$"});
  ASSERT_TRUE(killed.ok());
  EXPECT_EQ(killed->exit_code, 128 + 9);
  EXPECT_EQ(childOutput({"/no/such/program"}).error().kind, ErrorKind::not_found);
}

TEST(ChildOutput, OfAProgramThatPrintsWithoutEndIsRefused) {
  const auto begun = std::chrono::steady_clock::now();
  // What goes to its errors is looked at now and then, so this one takes its time.
  constexpr const char* kErrors = "while :; do head -c 10000 /dev/zero >&2; sleep 0.02; done";
  for (const char* command : {"yes", kErrors}) {
    const auto child = childOutput({"sh", "-c", command}, 100'000);
    ASSERT_FALSE(child.ok()) << command;
    EXPECT_EQ(child.error().kind, ErrorKind::refused) << command;
    EXPECT_EQ(child.error().what, "printed more output than is accepted") << command;
  }
  EXPECT_TRUE(childOutput({"sh", "-c", "head -c 100000 /dev/zero"}, 100'000).ok())
      << "just as much";
  EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::minutes(2))
      << "they were killed";
}

}  // namespace
}  // namespace rocinante
