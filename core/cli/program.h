#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/cli/command_line.h"

namespace rocinante::cli {

/// Exit codes of every program (docs/architecture.md, "Exit codes").
enum class Exit : int {
  done = 0,          ///< done, same, compatible
  no = 1,            ///< ran, and the answer is no, or something was not kept
  could_not_run = 2  ///< arguments, files, display; or nothing was judged
};

/// Adds --version and the examples to `program`, parses, runs `body`, catches what libraries throw,
/// prints an Error as one line on stderr ("rocinante-play: SENTENCE (PLACE)") and returns the exit
/// code. `examples` is printed below --help.
int run(const Program& program, int argc, char** argv, std::string_view examples,
        const std::function<Result<Exit>()>& body);

/// A subcommand, and what it does once it was asked for.
struct Subcommand {
  CommandLine line;
  std::function<Result<Exit>()> run;
};
/// Runs the one of them that was asked for: a body for run(), where Program::requireSubcommand().
Result<Exit> runChosen(const std::vector<Subcommand>& subcommands);

/// Becomes true on SIGINT or SIGTERM after catchStopSignals(); a second one more than half a second
/// after the first ends the process at once.
void catchStopSignals();
bool stopRequested();

/// While it lives, a stop signal takes effect within a second: work that has not ended 0.7 s after
/// the signal, because it does not look at stopRequested() (searching a damaged log, waiting for a
/// disk), is ended. Unfinished paths are removed, `sentence` is printed, and the exit code is
/// could_not_run. For work that leaves nothing else behind; one at a time.
class StopDeadline {
 public:
  /// `last` is called first, in a signal handler.
  explicit StopDeadline(std::string_view sentence, void (*last)() = nullptr);
  ~StopDeadline();
  StopDeadline(const StopDeadline&) = delete;
  StopDeadline& operator=(const StopDeadline&) = delete;
};

/// From now on this signal (SIGHUP, SIGUSR1) is counted and does not end the process; one that was
/// ignored when the process started (nohup) stays ignored. Signals that arrive together may count
/// as one.
void countSignal(int signal_number);
/// How often it arrived; 0 for a signal that is not counted.
std::uint32_t signalCount(int signal_number);

/// One line on stderr: "rocinante-NAME: TEXT", as plainText().
void warn(std::string_view text);

/// Print to standard output and standard error unchanged. Unlike fmt::print() they never throw:
/// work in progress must not end because output fails. run() reports failed writes to standard
/// output.
void say(std::string_view text);
void tell(std::string_view text);

}  // namespace rocinante::cli
