#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace rocinante::test {

/// What a program left behind. `exit_code` is 128 + the signal when a signal ended it.
struct ProgramResult {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// One of our programs, running as a user would run it. Its output goes to files, so nothing
/// blocks however much it writes. Killed when this object goes, or when the test does.
class Program {
 public:
  using Milliseconds = std::chrono::milliseconds;

  /// Starts bin/NAME ("rocinante-play") in `folder` (empty: the test's own folder). An argument
  /// list holds what follows the program's name.
  static Program start(const std::string& name, const std::vector<std::string>& arguments,
                       const std::filesystem::path& folder = {}) {
    Program program;
    program.name_ = name;
    const std::string path = (std::filesystem::path(ROCINANTE_BIN_DIR) / name).string();
    const std::string out_path = program.outPath().string();
    const std::string err_path = program.errPath().string();
    std::vector<char*> words{const_cast<char*>(path.c_str())};
    for (const std::string& argument : arguments) {
      words.push_back(const_cast<char*>(argument.c_str()));
    }
    words.push_back(nullptr);
    program.pid_ = ::fork();
    if (program.pid_ == 0) {
      // Only calls that are safe after fork in a process with threads.
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);
      // What a script starts in the background ignores it, and so would whatever that starts.
      ::signal(SIGINT, SIG_DFL);
      if (!folder.empty() && ::chdir(folder.c_str()) != 0) ::_exit(126);
      ::dup2(::open("/dev/null", O_RDONLY), 0);
      ::dup2(::open(out_path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644), 1);
      ::dup2(::open(err_path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644), 2);
      ::execv(path.c_str(), words.data());
      ::_exit(127);
    }
    return program;
  }

  /// Waits until a whole line on stderr holds `text` and returns the line. When the program ends
  /// or `within` passes first: the test fails with what was said instead, and the answer is empty.
  std::string waitForLine(std::string_view text, Milliseconds within = Milliseconds(30'000)) {
    return waitForLineIn(errPath(), "stderr", text, within);
  }
  /// The same of stdout.
  std::string waitForOutput(std::string_view text, Milliseconds within = Milliseconds(30'000)) {
    return waitForLineIn(outPath(), "stdout", text, within);
  }

  ::pid_t pid() const { return pid_; }

  void signal(int number) const {
    if (pid_ > 0 && !reaped_) ::kill(pid_, number);
  }

  /// Waits for the end. Kills the program and fails the test when `within` passes first.
  ProgramResult finish(Milliseconds within = Milliseconds(60'000)) {
    const auto give_up = std::chrono::steady_clock::now() + within;
    while (!ended()) {
      if (std::chrono::steady_clock::now() > give_up) {
        ADD_FAILURE() << name_ << " did not end within " << within.count() << " ms";
        kill();
        break;
      }
      std::this_thread::sleep_for(Milliseconds(2));
    }
    return {exit_code_, fileText(outPath()), fileText(errPath())};
  }

  /// Ctrl-C, then finish().
  ProgramResult stop(Milliseconds within = Milliseconds(60'000)) {
    signal(SIGINT);
    return finish(within);
  }

  Program(Program&& other) noexcept { *this = std::move(other); }
  Program& operator=(Program&& other) noexcept {
    std::swap(name_, other.name_);
    std::swap(folder_, other.folder_);
    std::swap(pid_, other.pid_);
    std::swap(reaped_, other.reaped_);
    std::swap(exit_code_, other.exit_code_);
    return *this;
  }
  ~Program() { kill(); }

 private:
  Program() = default;

  std::filesystem::path outPath() const { return *folder_ / "stdout"; }
  std::filesystem::path errPath() const { return *folder_ / "stderr"; }

  std::string waitForLineIn(const std::filesystem::path& path, const char* stream,
                            std::string_view text, Milliseconds within) {
    const auto give_up = std::chrono::steady_clock::now() + within;
    while (true) {
      // Looked at before the text is read: what a program says last must not be missed.
      const bool over = ended() || std::chrono::steady_clock::now() > give_up;
      const std::string said = fileText(path);
      std::size_t begin = 0;
      for (std::size_t end = 0; (end = said.find('\n', begin)) != said.npos; begin = end + 1) {
        const std::string line = said.substr(begin, end - begin);
        if (line.find(text) != line.npos) return line;
      }
      if (over) {
        ADD_FAILURE() << name_ << " never said `" << text << "` on " << stream << ", but:\n"
                      << said;
        return {};
      }
      std::this_thread::sleep_for(Milliseconds(2));
    }
  }

  static std::string fileText(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  bool ended() {
    if (reaped_ || pid_ <= 0) return true;
    int status = 0;
    if (::waitpid(pid_, &status, WNOHANG) != pid_) return false;
    reaped_ = true;
    exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return true;
  }

  void kill() {
    if (pid_ <= 0 || reaped_) return;
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
    reaped_ = true;
    exit_code_ = 128 + SIGKILL;
  }

  std::string name_;
  std::unique_ptr<TemporaryFolder> folder_ = std::make_unique<TemporaryFolder>();
  ::pid_t pid_ = -1;
  bool reaped_ = false;
  int exit_code_ = -1;
};

/// Runs a program to its end.
inline ProgramResult runProgram(const std::string& name, const std::vector<std::string>& arguments,
                                const std::filesystem::path& folder = {},
                                Program::Milliseconds within = Program::Milliseconds(60'000)) {
  return Program::start(name, arguments, folder).finish(within);
}

}  // namespace rocinante::test
