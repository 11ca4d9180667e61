#include "core/base/child_process.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>

namespace rocinante {
namespace {

int exitCodeOf(pid_t child) {
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(StartChild, GivesItsArgumentsAndStreamsAndNothingElse) {
  std::array<int, 2> pipe{};
  ASSERT_EQ(::pipe2(pipe.data(), O_CLOEXEC), 0);
  const auto child = startChild(
      {"sh", "-c", "cat; echo \"$1\"; echo gone >&2; exit 3", "sh", "a b"}, {-1, pipe[1], -1});
  ::close(pipe[1]);
  ASSERT_TRUE(child.ok()) << child.error().text();
  std::array<char, 64> said{};
  std::string all;
  for (ssize_t got = 0; (got = ::read(pipe[0], said.data(), said.size())) > 0;) {
    all.append(said.data(), static_cast<std::size_t>(got));
  }
  ::close(pipe[0]);
  EXPECT_EQ(all, "a b\n");
  EXPECT_EQ(exitCodeOf(*child), 3);
}

TEST(StartChild, HasAProcessGroupOfItsOwnIfWanted) {
  for (const bool own_group : {false, true}) {
    const auto child = startChild({"sleep", "60"}, {}, own_group);
    ASSERT_TRUE(child.ok()) << child.error().text();
    EXPECT_EQ(::getpgid(*child), own_group ? *child : ::getpgrp());
    ::kill(*child, SIGKILL);
    exitCodeOf(*child);
  }
}

TEST(StartChild, SaysThatThereIsNoSuchProgram) {
  const auto child = startChild({"rocinante-no-such-program"}, {});
  ASSERT_FALSE(child.ok());
  EXPECT_EQ(child.error().kind, ErrorKind::not_found);
  EXPECT_EQ(child.error().where, "rocinante-no-such-program");
}

}  // namespace
}  // namespace rocinante
