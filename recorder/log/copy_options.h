#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/cli/program.h"
#include "recorder/copy/log_make.h"

namespace CLI {
class App;
}

namespace rocinante {

/// What every subcommand that makes a log takes: -o, --force, --compression, --json.
struct CopyArguments {
  std::string output;
  bool force = false;
  std::string compression = "zstd";
  bool without_attachments = false;
  bool json = false;
};

void addCopyArguments(CLI::App& app, CopyArguments& arguments);
/// --from and --until, by time or event; and which messages.
void addTimeArguments(CLI::App& app, SelectionOptions& selection);
void addChoiceArguments(CLI::App& app, SelectionOptions& selection);

/// Reads the arguments, catches Ctrl-C, shows a progress line while `work` runs.
Result<CopyReport> runCopy(const CopyArguments& arguments, const std::string& doing,
                           const std::function<Result<CopyReport>(const MakeOptions&)>& work);
Result<MakeOptions> readCopyArguments(const CopyArguments& arguments);
/// What is said when the user has asked to stop.
inline constexpr const char* kStopped = "stopped; nothing was made";
/// A line on the terminal, and an error once the user has asked to stop.
CopyProgress stoppableProgress(const std::string& doing);

/// Says on standard output what was made, and on standard error what could not be used; answers
/// with the exit code: no when something is missing or was damaged.
Result<cli::Exit> tellCopy(const CopyArguments& arguments, const CopyReport& report);
/// The second half of it.
cli::Exit tellGaps(const CopyReport& report);

}  // namespace rocinante
