#include "core/base/child_process.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>

#include "tests/support/temporary_folder.h"

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

TEST(ChildProcess, MayWriteWithoutAReader) {
  auto child = ChildProcess::start({"sh", "-c",
                                    "i=0; while [ $i -lt 3000 ]; do echo 'a line of two and thirty "
                                    "bytes..'; i=$((i+1)); done >&2; "
                                    "echo last >&2; exit 3"},
                                   {});
  ASSERT_TRUE(child.ok()) << child.error().text();
  const ChildProcess::End end = child->wait();
  EXPECT_FALSE(end.ok());
  EXPECT_EQ(end.text(), "exit 3");
  EXPECT_EQ(child->poll()->code, 3) << "known ever after";
  EXPECT_TRUE(child->errorOutput().ends_with("\nlast")) << child->errorOutput(100);
  EXPECT_EQ(child->errorOutput().size(), 65535U) << "its end, without the line feed";
  EXPECT_EQ(onOneLine(child->errorOutput(10)), "es..; last");
}

TEST(ChildProcess, IsEndedWithItsOwner) {
  test::TemporaryFolder folder;
  const auto script = "trap 'echo ended > " + (folder / "said").string() + "; exit' TERM; echo > " +
                      (folder / "up").string() + "; while :; do sleep 0.01; done";
  {
    auto child = ChildProcess::start({"sh", "-c", script}, {});
    ASSERT_TRUE(child.ok()) << child.error().text();
    EXPECT_FALSE(child->poll());
    while (!std::filesystem::exists(folder / "up")) std::this_thread::yield();
    const ChildProcess moved = std::move(*child);
  }
  EXPECT_TRUE(std::filesystem::exists(folder / "said"));
  auto killed = ChildProcess::start({"sh", "-c", "kill -9 $$"}, {.last_signal = SIGKILL});
  ASSERT_TRUE(killed.ok());
  EXPECT_EQ(killed->wait().text(), "signal 9");
}

TEST(ChildProcess, HasOneStreamOfItsOwnerIfWanted) {
  auto talks = ChildProcess::start({"sh", "-c", "echo out; echo err >&2"},
                                   {.ours = ChildProcess::Ours::output});
  ASSERT_TRUE(talks.ok()) << talks.error().text();
  ChildProcess moved = std::move(*talks);
  EXPECT_EQ(talks->stream(), -1);
  std::array<char, 64> out{};
  EXPECT_EQ(::read(moved.stream(), out.data(), out.size()), 4);
  EXPECT_EQ(::read(moved.stream(), out.data(), out.size()), 0);
  EXPECT_TRUE(moved.wait().ok());
  EXPECT_EQ(moved.errorOutput(), "err");

  auto listens = ChildProcess::start({"sh", "-c", "cat >&2"}, {.ours = ChildProcess::Ours::input});
  ASSERT_TRUE(listens.ok()) << listens.error().text();
  EXPECT_EQ(::send(listens->stream(), "in", 2, MSG_NOSIGNAL), 2);
  listens->closeStream();
  EXPECT_EQ(listens->stream(), -1);
  EXPECT_TRUE(listens->wait().ok());
  EXPECT_EQ(listens->errorOutput(), "in");
}

TEST(ChildProcess, ReadsATextAndPassesItsErrorsOn) {
  std::array<int, 2> pipe{};
  ASSERT_EQ(::pipe2(pipe.data(), O_CLOEXEC), 0);
  auto child = ChildProcess::start({"sh", "-c", "cat >&2; kill -9 $$"},
                                   {.err = pipe[1], .input_text = "from memory"});
  ::close(pipe[1]);
  ASSERT_TRUE(child.ok()) << child.error().text();
  EXPECT_EQ(child->wait().text(), "signal 9");
  std::array<char, 64> said{};
  const ssize_t got = ::read(pipe[0], said.data(), said.size());
  ::close(pipe[0]);
  EXPECT_EQ(std::string(said.data(), static_cast<std::size_t>(got)), "from memory");
  EXPECT_EQ(child->errorOutput(), "");
  EXPECT_EQ(child->errorBytes(), 0U);
}

TEST(ChildProcess, GoesOnWithoutItsOwnerIfAsked) {
  std::array<int, 2> in{}, out{};
  ASSERT_EQ(::pipe2(in.data(), O_CLOEXEC), 0);
  ASSERT_EQ(::pipe2(out.data(), O_CLOEXEC), 0);
  {
    const auto child = ChildProcess::start({"sh", "-c", "read line; echo \"$line\""},
                                           {.in = in[0], .out = out[1], .last_signal = 0});
    ASSERT_TRUE(child.ok()) << child.error().text();
  }
  ::close(out[1]);
  EXPECT_EQ(::write(in[1], "on\n", 3), 3);
  std::array<char, 64> said{};
  EXPECT_EQ(::read(out[0], said.data(), said.size()), 3);
  for (const int each : {in[0], in[1], out[0]}) ::close(each);
  EXPECT_GT(::wait(nullptr), 0);
}

TEST(WaitForChild, TellsHowItEnded) {
  const auto child = startChild({"sh", "-c", "exit 3"}, {});
  ASSERT_TRUE(child.ok()) << child.error().text();
  EXPECT_EQ(waitForChild(*child).text(), "exit 3");
}

}  // namespace
}  // namespace rocinante
