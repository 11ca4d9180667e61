#include "core/self_test/fact_jobs.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <thread>

#include "core/base/duration_text.h"

namespace rocinante {
namespace {

using SteadyClock = std::chrono::steady_clock;

// Far more than all facts together need; a driver that prints without end cannot fill the memory.
constexpr std::size_t kMaxOutput = 1 << 20;
// This much of an invalid answer is reported.
constexpr std::size_t kMaxQuoted = 200;

struct RunningJob {
  pid_t child = -1;
  int output = -1;  ///< the reading end
  std::string printed;
  std::string failure;  ///< why there is no answer
};

RunningJob start(const FactJob& job) {
  RunningJob running;
  int ends[2] = {-1, -1};
  if (::pipe2(ends, O_CLOEXEC) == 0) running.child = ::fork();
  if (running.child == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::dup2(ends[1], STDOUT_FILENO);
    ::dup2(ends[1], STDERR_FILENO);
    ::dprintf(STDOUT_FILENO, "\n%s\n", factsWire(job.find()).c_str());
    ::_exit(0);
  }
  if (running.child < 0) {
    running.failure = fmt::format("cannot start a process: {}", std::strerror(errno));
  }
  ::close(ends[1]);
  running.output = ends[0];
  return running;
}

/// Reads the output to its end, or what is there at `until`; false when it did not end.
bool readOutput(RunningJob& job, SteadyClock::time_point until) {
  char piece[4096];
  while (job.printed.size() < kMaxOutput) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - SteadyClock::now());
    pollfd waiting{job.output, POLLIN, 0};
    const int news = ::poll(&waiting, 1, static_cast<int>(std::max<std::int64_t>(left.count(), 0)));
    if (news == 0) return false;
    if (news < 0) continue;
    const ssize_t got = ::read(job.output, piece, sizeof piece);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    job.printed.append(piece, static_cast<std::size_t>(got));
  }
  return true;
}

/// Waits until the child has ended, or `until`; false then.
bool waitFor(pid_t child, int& status, SteadyClock::time_point until) {
  for (;;) {
    const pid_t ended = ::waitpid(child, &status, WNOHANG);
    if (ended == child || (ended < 0 && errno != EINTR)) return true;
    if (SteadyClock::now() >= until) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

/// Reads what the child says, ends it, and tells what went wrong with it.
void finish(RunningJob& job, SteadyClock::time_point until, Nanoseconds limit) {
  if (job.child < 0) return;
  int status = 0;
  const bool is_read = readOutput(job, until);
  ::close(job.output);
  if (!is_read || !waitFor(job.child, status, until)) {
    // A child that is stuck in a device cannot be killed and is not waited for.
    ::kill(job.child, SIGKILL);
    job.failure = fmt::format("no answer within {} s", secondsText(limit));
  } else if (WIFSIGNALED(status)) {
    job.failure = fmt::format("it was ended by signal {} ({})", WTERMSIG(status),
                              ::strsignal(WTERMSIG(status)));
  } else if (WEXITSTATUS(status) != 0) {
    job.failure = fmt::format("it ended with exit {}", WEXITSTATUS(status));
  }
}

/// The facts of the last line that holds some; from other output the first line.
std::vector<SelfTestFact> answerOf(const std::string& printed, std::string& other) {
  std::vector<SelfTestFact> answer;
  for (std::size_t at = 0; at < printed.size();) {
    const std::size_t end = std::min(printed.find('\n', at), printed.size());
    const std::string_view line = std::string_view(printed).substr(at, end - at);
    if (auto facts = factsOfWire(line)) {
      answer = std::move(*facts);
    } else if (other.empty()) {
      other = line.substr(0, kMaxQuoted);
    }
    at = end + 1;
  }
  return answer;
}

}  // namespace

FactJob jobOfProgram(std::vector<std::string> names, const std::filesystem::path& program,
                     const std::string& advice) {
  return {names, [=] {
            std::vector<SelfTestFact> facts;
            if (::access(program.c_str(), X_OK) == 0) {
              const std::string only = fmt::format("{}", fmt::join(names, ","));
              ::execl(program.c_str(), program.c_str(), "--only", only.c_str(), nullptr);
              ::_exit(127);  // as a shell when it cannot run a program
            }
            const std::string found = program.filename().string() + " is not installed here";
            for (const std::string& name : names) {
              facts.push_back({name, SelfTestFact::State::missing, found, advice});
            }
            return facts;
          }};
}

std::vector<SelfTestFact> findFacts(const std::vector<FactJob>& jobs, Nanoseconds limit) {
  const auto until = SteadyClock::now() + limit;
  std::vector<RunningJob> running;
  for (const FactJob& job : jobs) running.push_back(start(job));
  std::vector<SelfTestFact> facts;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    finish(running[i], until, limit);
    std::string other;
    const std::vector<SelfTestFact> answer = answerOf(running[i].printed, other);
    if (!other.empty()) other.insert(0, ": ");
    const std::string failure = running[i].failure.empty() ? "no answer" : running[i].failure;
    for (const std::string& name : jobs[i].names) {
      const auto found = std::ranges::find(answer, name, &SelfTestFact::name);
      facts.push_back(
          found != answer.end()
              ? *found
              : SelfTestFact{
                    name, SelfTestFact::State::missing, failure + other,
                    "please report it, with the output of `rocinante --self-test --json`"});
    }
  }
  return facts;
}

}  // namespace rocinante
