#include "tests/bench/render/timed_process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace rocinante::bench {
namespace {

std::vector<char*> pointersTo(const std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
  pointers.push_back(nullptr);
  return pointers;
}

double secondsOf(const timeval& time) {
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
}

}  // namespace

std::optional<ProcessTimes> timedRun(const std::vector<std::string>& words,
                                     const std::map<std::string, std::string>& environment) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  const pid_t child = ::fork();
  if (child == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (const auto& [name, value] : environment) ::setenv(name.c_str(), value.c_str(), 1);
    const int nothing = ::open("/dev/null", O_RDWR);
    for (const int stream : {0, 1, 2}) ::dup2(nothing, stream);
    ::execv(words.front().c_str(), pointersTo(words).data());
    ::_exit(127);
  }
  int answer = 0;
  rusage used{};
  if (child < 0 || ::wait4(child, &answer, 0, &used) != child) return std::nullopt;
  if (!WIFEXITED(answer) || WEXITSTATUS(answer) != 0) return std::nullopt;
  return ProcessTimes{std::chrono::duration<double>(Clock::now() - begin).count(),
                      secondsOf(used.ru_utime) + secondsOf(used.ru_stime)};
}

VirtualDisplay::VirtualDisplay() {
  const std::string program = installed("Xvfb");
  int told[2];
  if (program.empty() || ::pipe(told) != 0) return;
  pid_ = ::fork();
  if (pid_ == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    const int nothing = ::open("/dev/null", O_RDWR);
    ::dup2(told[1], 3);
    for (const int stream : {0, 1, 2}) ::dup2(nothing, stream);
    ::execl(program.c_str(), "Xvfb", "-displayfd", "3", "-screen", "0", "1920x1200x24", nullptr);
    ::_exit(127);
  }
  ::close(told[1]);
  // It says its number, then a line's end, when it is ready for clients.
  std::string number;
  for (char digit = 0; ::read(told[0], &digit, 1) == 1 && digit != '\n';) number += digit;
  if (!number.empty()) name_ = ":" + number;
  ::close(told[0]);
}

VirtualDisplay::~VirtualDisplay() {
  if (pid_ <= 0) return;
  ::kill(pid_, SIGTERM);
  ::waitpid(pid_, nullptr, 0);
}

std::string installed(const std::string& name) {
  std::istringstream folders(std::getenv("PATH") == nullptr ? "" : std::getenv("PATH"));
  for (std::string folder; std::getline(folders, folder, ':');) {
    const auto path = std::filesystem::path(folder) / name;
    if (::access(path.c_str(), X_OK) == 0) return path.string();
  }
  return {};
}

}  // namespace rocinante::bench
