#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/cli/program.h"
#include "core/copy/log_make.h"

namespace CLI {
class App;
}

namespace rocinante {

/// Options of every subcommand that makes a log: -o, --force, --compression, --json.
struct CopyArguments {
  std::string output;
  bool force = false;
  std::string compression = "zstd";
  bool without_attachments = false;
  bool json = false;
};

void addCopyArguments(CLI::App& app, CopyArguments& arguments);
/// Add --from and --until, by time or event, and the options that choose messages.
void addTimeArguments(CLI::App& app, SelectionOptions& selection);
void addChoiceArguments(CLI::App& app, SelectionOptions& selection);

/// Parses the arguments, catches Ctrl-C, and shows a progress line while `work` runs.
Result<CopyReport> runCopy(const CopyArguments& arguments, const std::string& doing,
                           const std::function<Result<CopyReport>(const MakeOptions&)>& work);
Result<MakeOptions> readCopyArguments(const CopyArguments& arguments);
/// The error after the user asked to stop.
inline constexpr const char* kStopped = "stopped; nothing was made";
/// Shows a progress line, and fails once the user has asked to stop.
CopyProgress stoppableProgress(const std::string& doing);

/// Reports the output on standard output, and unusable input on standard error. Returns Exit::no
/// when something is missing or was damaged.
Result<cli::Exit> tellCopy(const CopyArguments& arguments, const CopyReport& report);
/// The part of tellCopy() for unusable input.
cli::Exit tellGaps(const CopyReport& report);

}  // namespace rocinante
