#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace CLI {
class App;
}

namespace rocinante::cli {

/// What every program answers (docs/architecture.md, "Exit codes").
enum class Exit : int {
  done = 0,          ///< done, same, compatible
  no = 1,            ///< ran, and the answer is no, or something was not kept
  could_not_run = 2  ///< arguments, files, display; or nothing was judged
};

/// Adds --version and the examples to `app`, parses, runs `body`, catches what libraries throw,
/// prints an Error as one line on stderr ("rocinante-play: SENTENCE (PLACE)") and returns the exit
/// code. `examples` is printed below --help.
int run(CLI::App& app, int argc, char** argv, std::string_view examples,
        const std::function<Result<Exit>()>& body);

/// Becomes true on SIGINT or SIGTERM once catchStopSignals() was called; one that comes more than
/// half a second after the first ends the process at once.
void catchStopSignals();
bool stopRequested();

/// While it lives, a stop signal is followed within a second: what has not ended 0.7 s after it,
/// because it is where nothing looks at stopRequested() (a damaged log is searched, a disk is
/// waited for), is ended. Paths that are unfinished are removed, `sentence` is told, and the exit
/// code is could_not_run. For work that leaves nothing behind but those; one at a time.
class StopDeadline {
 public:
  /// `last` is called first, in a signal handler.
  explicit StopDeadline(std::string_view sentence, void (*last)() = nullptr);
  ~StopDeadline();
  StopDeadline(const StopDeadline&) = delete;
  StopDeadline& operator=(const StopDeadline&) = delete;
};

/// From now on this signal (SIGHUP, SIGUSR1) is counted and ends nothing; one that this process was
/// started to ignore (nohup) stays ignored. Signals that come together may count as one.
void countSignal(int signal_number);
/// How often it came; 0 for one that is not counted.
std::uint32_t signalCount(int signal_number);

/// One line on stderr: "rocinante-NAME: TEXT", as plainText().
void warn(std::string_view text);

/// To standard output and to standard error as they are. Never throws, as fmt::print() does: work
/// that goes on must not end because nobody can be told. run() reports what standard output
/// refused.
void say(std::string_view text);
void tell(std::string_view text);

}  // namespace rocinante::cli
