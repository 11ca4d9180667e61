#include <gtest/gtest.h>
#include <signal.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "core/base/unfinished_path.h"
#include "core/cli/program.h"
#include "tests/support/temporary_folder.h"

namespace rocinante::test {
namespace {

void makeFile(const std::filesystem::path& path) { std::ofstream(path) << "half"; }

/// Runs `work` in its own process, sends it SIGTERM once it reports that it is ready, and returns
/// its exit code, or minus the signal that ended it. `said` is its standard error output.
int afterStop(const std::function<void(const std::function<void()>& ready)>& work,
              std::string& said) {
  std::array<int, 2> ready{};
  std::array<int, 2> errors{};
  EXPECT_EQ(::pipe(ready.data()), 0);
  EXPECT_EQ(::pipe(errors.data()), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(errors[1], STDERR_FILENO);
    ::close(errors[0]);
    ::close(errors[1]);
    work([&] { (void)!::write(ready[1], "r", 1); });
    ::_exit(0);
  }
  ::close(ready[1]);
  ::close(errors[1]);
  char byte = 0;
  EXPECT_EQ(::read(ready[0], &byte, 1), 1);
  ::kill(child, SIGTERM);
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  std::array<char, 256> text{};
  for (ssize_t got = 0; (got = ::read(errors[0], text.data(), text.size())) > 0;) {
    said.append(text.data(), static_cast<std::size_t>(got));
  }
  ::close(ready[0]);
  ::close(errors[0]);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

TEST(StopDeadline, EndsWorkThatDoesNotLookAndLeavesNothingHalfMade) {
  TemporaryFolder folder;
  std::string said;
  const int exit = afterStop(
      [&](const std::function<void()>& ready) {
        std::filesystem::create_directory(folder / "pieces");
        const UnfinishedPath pieces(folder / "pieces");
        makeFile(folder / "pieces/one.part");
        const UnfinishedPath one(folder / "pieces/one.part");
        makeFile(folder / "done");
        UnfinishedPath done(folder / "done");
        done.keep();
        cli::catchStopSignals();
        const cli::StopDeadline deadline("stopped; nothing was made");
        ready();
        while (true) ::pause();
      },
      said);
  EXPECT_EQ(exit, 2);
  EXPECT_NE(said.find(": stopped; nothing was made\n"), std::string::npos) << said;
  EXPECT_FALSE(std::filesystem::exists(folder / "pieces"));
  EXPECT_TRUE(std::filesystem::exists(folder / "done"));
}

TEST(StopDeadline, LeavesWorkThatEndsByItselfAlone) {
  std::string said;
  const int exit = afterStop(
      [&](const std::function<void()>& ready) {
        cli::catchStopSignals();
        {
          const cli::StopDeadline deadline("too late");
          ready();
          while (!cli::stopRequested()) ::usleep(1000);
        }
        // No timer is left that could end the process later.
        itimerval left{};
        ::getitimer(ITIMER_REAL, &left);
        ::_exit(left.it_value.tv_sec == 0 && left.it_value.tv_usec == 0 ? 7 : 8);
      },
      said);
  EXPECT_EQ(exit, 7);
  EXPECT_EQ(said, "");
}

TEST(UnfinishedPath, GoesWithItsOwnerUnlessItIsKept) {
  TemporaryFolder folder;
  makeFile(folder / "a");
  makeFile(folder / "b");
  {
    UnfinishedPath a(folder / "a");
    UnfinishedPath moved(std::move(a));
    EXPECT_TRUE(std::filesystem::exists(folder / "a"));
    UnfinishedPath b(folder / "b");
    b.keep();
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "a"));
  EXPECT_TRUE(std::filesystem::exists(folder / "b"));
}

}  // namespace
}  // namespace rocinante::test
