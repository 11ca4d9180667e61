#include "core/cli/program.h"

#include <signal.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <mutex>

#include "core/base/plain_text.h"
#include "core/base/reader_notice.h"
#include "core/base/unfinished_path.h"
#include "core/base/version.h"
#include "core/cli/help_formatter.h"
#include "core/cli/terminal.h"
#include "core/cli/usage_fault.h"

namespace rocinante::cli {
namespace {

std::atomic<bool> stop_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "set from a signal handler");

std::string program_name = "rocinante";

// A single request to stop can arrive as several signals: timeout(1) sends one to the process and
// one to the group, and an interrupted shell script forwards the one that its child already
// received.
constexpr std::int64_t kSameWishMs = 500;
std::atomic<std::int64_t> stop_requested_at_ms{0};
static_assert(std::atomic<std::int64_t>::is_always_lock_free, "set from a signal handler");

std::int64_t steadyMilliseconds() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);  // async-signal-safe
  return now.tv_sec * 1'000 + now.tv_nsec / 1'000'000;
}

// State of the StopDeadline that is alive.
constexpr suseconds_t kStopWithinUs = 700'000;
std::atomic<bool> has_deadline{false};
std::string deadline_farewell;
void (*deadline_last)() = nullptr;

void onDeadline(int) {
  if (!has_deadline.load()) return;
  if (deadline_last != nullptr) deadline_last();
  removeUnfinishedPaths();
  // A failed write is ignored: nothing else can be done here.
  (void)!::write(STDERR_FILENO, deadline_farewell.data(), deadline_farewell.size());
  ::_exit(static_cast<int>(Exit::could_not_run));
}

void startDeadline() {
  const itimerval within{{0, 0}, {0, kStopWithinUs}};
  ::setitimer(ITIMER_REAL, &within, nullptr);
}

void onStopSignal(int signal_number) {
  if (!stop_requested.exchange(true) && has_deadline.load()) startDeadline();
  std::int64_t first = 0;
  const std::int64_t now = steadyMilliseconds();
  if (stop_requested_at_ms.compare_exchange_strong(first, now) || now - first < kSameWishMs) return;
  // A later signal ends the process at once.
  ::signal(signal_number, SIG_DFL);
  ::raise(signal_number);
}

std::array<std::atomic<std::uint32_t>, NSIG> signal_counts{};
static_assert(std::atomic<std::uint32_t>::is_always_lock_free, "counted in a signal handler");

void onCountedSignal(int signal_number) {
  signal_counts[static_cast<std::size_t>(signal_number)].fetch_add(1);
}

// Keys of notices that were printed, one a line; guarded, since threads print.
std::mutex reported_mutex;
std::string reported_notices;

/// Remembers the notices of readers that this output states.
void noteReported(std::string_view output) {
  if (!hasReaderNotices()) return;
  for (const ReaderNotice& notice : readerNotices()) {
    if (output.find(notice.key) == output.npos) continue;
    const std::lock_guard lock(reported_mutex);
    reported_notices += notice.key + '\n';
  }
}

/// Prints what the program left unsaid; true when there is any notice.
bool tellNotices() {
  for (const ReaderNotice& notice : readerNotices()) {
    const bool is_reported = [&] {
      const std::lock_guard lock(reported_mutex);
      return reported_notices.find(notice.key + '\n') != reported_notices.npos;
    }();
    if (!is_reported) warn(notice.text);
  }
  return hasReaderNotices();
}

}  // namespace

int run(const Program& program, int argc, char** argv, std::string_view examples,
        const std::function<Result<Exit>()>& body) {
  fillClosedStandardStreams();
  // Makes write() report the file size limit as an error, like a full disk.
  ::signal(SIGXFSZ, SIG_IGN);
  // Ignored by whoever started us, it would take how our own children ended.
  ::signal(SIGCHLD, SIG_DFL);
  CLI::App& app = program.app();
  program_name = app.get_name();
  app.set_version_flag("--version", version());
  setHelp(app, examples);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& fault) {
    // --help and --version arrive here too, with code 0.
    if (fault.get_exit_code() == 0) return app.exit(fault, std::cout, std::cerr);
    warn(usageFault(app, fault));
    return static_cast<int>(Exit::could_not_run);
  }
  try {
    const Result<Exit> outcome = body();
    if (!outcome) noteReported(outcome.error().text());
    const bool is_doubtful = tellNotices();
    if (!outcome) {
      warn(outcome.error().text());
      // The body reached an answer, but output failed.
      return static_cast<int>(std::ferror(stdout) != 0 ? Exit::no : Exit::could_not_run);
    }
    // A full disk or a closed pipe must not look like success.
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
      warn(std::string("cannot write to standard output: ") + std::strerror(errno));
      return static_cast<int>(Exit::no);
    }
    return static_cast<int>(*outcome == Exit::done && is_doubtful ? Exit::no : *outcome);
  } catch (const std::exception& fault) {
    warn(std::string("stopped by an internal error: ") + fault.what());
    return static_cast<int>(Exit::could_not_run);
  }
}

Result<Exit> runChosen(const std::vector<Subcommand>& subcommands) {
  for (const Subcommand& each : subcommands) {
    if (each.line.isChosen()) return each.run();
  }
  return Exit::could_not_run;
}

void catchStopSignals() {
  struct sigaction action {};
  action.sa_handler = onStopSignal;
  // No SA_RESTART: a blocking call must return.
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
}

void countSignal(int signal_number) {
  struct sigaction before {};
  if (::sigaction(signal_number, nullptr, &before) == 0 && before.sa_handler == SIG_IGN) return;
  struct sigaction action {};
  action.sa_handler = onCountedSignal;
  action.sa_flags = SA_RESTART;
  ::sigaction(signal_number, &action, nullptr);
}

std::uint32_t signalCount(int signal_number) {
  return signal_counts.at(static_cast<std::size_t>(signal_number)).load();
}

StopDeadline::StopDeadline(std::string_view sentence, void (*last)()) {
  deadline_farewell = program_name + ": " + std::string(sentence) + "\n";
  deadline_last = last;
  struct sigaction action {};
  action.sa_handler = onDeadline;
  ::sigaction(SIGALRM, &action, nullptr);
  has_deadline.store(true);
  if (stopRequested()) startDeadline();
}

StopDeadline::~StopDeadline() {
  has_deadline.store(false);
  const itimerval never{};
  ::setitimer(ITIMER_REAL, &never, nullptr);
}

bool stopRequested() { return stop_requested.load(); }

void warn(std::string_view text) {
  // The text may contain untrusted names; the line breaks of a multi-line message stay.
  std::string shown = program_name + ": ";
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    shown += plainText(text.substr(at, end - at)) + '\n';
    at = end + 1;
  }
  tell(shown);
}

void say(std::string_view text) {
  noteReported(text);
  std::fwrite(text.data(), 1, text.size(), stdout);
}

void tell(std::string_view text) {
  noteReported(text);
  std::fwrite(text.data(), 1, text.size(), stderr);
}

}  // namespace rocinante::cli
