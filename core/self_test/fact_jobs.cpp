#include "core/self_test/fact_jobs.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <thread>

#include "core/base/duration_text.h"

namespace rocinante {
namespace {

using SteadyClock = std::chrono::steady_clock;

// Far more than all facts together need; a driver that prints without end cannot fill the memory.
constexpr std::size_t kMaxOutput = 1 << 20;
// This much of an invalid answer is reported.
constexpr std::size_t kMaxQuoted = 200;
// A shell's exit code when it cannot run a program.
constexpr int kCannotRun = 127;

struct RunningJob {
  pid_t child = -1;
  int output = -1;  ///< the reading end; -1 once it has ended
  std::string said;
  std::string failure;  ///< why there is no answer
};

[[noreturn]] void beChild(const FactJob& job, int output) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::dup2(output, STDOUT_FILENO);
  ::dup2(output, STDERR_FILENO);
  if (!job.program.empty()) {
    std::vector<std::string> words{job.program.string()};
    words.insert(words.end(), job.arguments.begin(), job.arguments.end());
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    ::execv(job.program.c_str(), arguments.data());
    ::_exit(kCannotRun);
  }
  const std::string line = "\n" + factsWire(job.find()) + "\n";
  for (std::size_t at = 0; at < line.size();) {
    const ssize_t written = ::write(STDOUT_FILENO, line.data() + at, line.size() - at);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) break;
    at += static_cast<std::size_t>(written);
  }
  ::_exit(0);
}

RunningJob start(const FactJob& job) {
  RunningJob running;
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
    running.failure = fmt::format("cannot create a pipe: {}", std::strerror(errno));
    return running;
  }
  running.child = ::fork();
  if (running.child == 0) beChild(job, ends[1]);
  ::close(ends[1]);
  running.output = ends[0];
  if (running.child < 0)
    running.failure = fmt::format("cannot start a process: {}", std::strerror(errno));
  return running;
}

/// Reads the available output; closes the pipe at its end.
void readSome(RunningJob& running) {
  std::array<char, 4096> piece;
  const ssize_t got = ::read(running.output, piece.data(), piece.size());
  if (got < 0 && errno == EINTR) return;
  if (got > 0 && running.said.size() < kMaxOutput) {
    running.said.append(piece.data(), static_cast<std::size_t>(got));
    return;
  }
  ::close(running.output);
  running.output = -1;
}

/// Waits until every job has closed its output, or `until`.
void readAll(std::vector<RunningJob>& jobs, SteadyClock::time_point until) {
  for (;;) {
    std::vector<pollfd> waiting;
    std::vector<RunningJob*> whose;
    for (RunningJob& job : jobs) {
      if (job.output < 0) continue;
      waiting.push_back({job.output, POLLIN, 0});
      whose.push_back(&job);
    }
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - SteadyClock::now());
    if (waiting.empty() || left.count() <= 0) return;
    ::poll(waiting.data(), waiting.size(), static_cast<int>(left.count()));
    for (std::size_t i = 0; i < waiting.size(); ++i) {
      if (waiting[i].revents != 0) readSome(*whose[i]);
    }
  }
}

/// Waits until the child has ended, or `until`; false then.
bool waitFor(pid_t child, int& status, SteadyClock::time_point until) {
  for (;;) {
    const pid_t ended = ::waitpid(child, &status, WNOHANG);
    if (ended == child) return true;
    if (ended < 0 && errno != EINTR) return true;
    if (SteadyClock::now() >= until) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

/// Ends the child and says what went wrong with it.
void finish(RunningJob& running, SteadyClock::time_point until, Nanoseconds limit) {
  const bool is_open = running.output >= 0;
  if (is_open) ::close(running.output);
  if (running.child < 0) return;
  int status = 0;
  if (is_open || !waitFor(running.child, status, until)) {
    // A child that is stuck in a device cannot be killed and is not waited for.
    ::kill(running.child, SIGKILL);
    running.failure = fmt::format("no answer within {} s", secondsText(limit));
  } else if (WIFSIGNALED(status)) {
    running.failure = fmt::format("it was ended by signal {} ({})", WTERMSIG(status),
                                  ::strsignal(WTERMSIG(status)));
  } else if (WEXITSTATUS(status) != 0) {
    running.failure = fmt::format("it ended with exit {}", WEXITSTATUS(status));
  }
}

/// The last line that holds facts; from other output the first line.
std::optional<std::vector<SelfTestFact>> answerOf(const std::string& said, std::string& other) {
  std::optional<std::vector<SelfTestFact>> answer;
  for (std::size_t at = 0; at < said.size();) {
    const std::size_t end = std::min(said.find('\n', at), said.size());
    const std::string_view line = std::string_view(said).substr(at, end - at);
    if (auto facts = factsOfWire(line)) {
      answer = std::move(facts);
    } else if (other.empty()) {
      other = line.substr(0, kMaxQuoted);
    }
    at = end + 1;
  }
  return answer;
}

}  // namespace

std::vector<SelfTestFact> findFacts(const std::vector<FactJob>& jobs, Nanoseconds limit) {
  const auto until = SteadyClock::now() + limit;
  std::vector<RunningJob> running;
  std::vector<bool> is_there;
  for (const FactJob& job : jobs) {
    is_there.push_back(job.program.empty() || ::access(job.program.c_str(), X_OK) == 0);
    running.push_back(is_there.back() ? start(job) : RunningJob());
  }
  readAll(running, until);
  std::vector<SelfTestFact> facts;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    finish(running[i], until, limit);
    std::string other;
    const auto answer = answerOf(running[i].said, other);
    for (const std::string& name : jobs[i].names) {
      const auto is_it = [&](const SelfTestFact& fact) { return fact.name == name; };
      if (answer) {
        const auto found = std::find_if(answer->begin(), answer->end(), is_it);
        if (found != answer->end()) {
          facts.push_back(*found);
          continue;
        }
      }
      SelfTestFact fact{name, SelfTestFact::State::missing, "", ""};
      if (!is_there[i]) {
        fact.says = fmt::format("{} is not installed here", jobs[i].program.filename().string());
        fact.advice = jobs[i].without_program;
      } else {
        fact.says = running[i].failure.empty() ? "no answer" : running[i].failure;
        if (!other.empty()) fact.says += ": " + other;
        fact.advice = "please report it, with the output of `rocinante --self-test --json`";
      }
      facts.push_back(std::move(fact));
    }
  }
  return facts;
}

}  // namespace rocinante
