#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/cell/cell.h"
#include "core/cli/program.h"
#include "core/cli/progress_line.h"
#include "core/copy/log_make.h"
#include "core/log/log_reader.h"

namespace rocinante {

using cli::ProgressLine;

/// A TextSink that writes all of `text` to standard output, or fails.
Status toStandardOutput(std::string_view text);

/// The time between the moments of `--every`, which is above 0 and gives at most `most` of them in
/// a span: a clock that was set while it was recorded makes one of 50 years.
Result<Nanoseconds> readEvery(const std::string& text, Nanoseconds span, std::int64_t most);

/// Options of every subcommand that makes a log: -o, --force, --compression, --json.
struct CopyArguments {
  std::string output;
  bool force = false;
  std::string compression = "zstd";
  bool without_attachments = false;
  bool json = false;
};

void addCopyArguments(cli::CommandLine app, CopyArguments& arguments);
/// Add --from and --until, by time or event, and the options that choose messages.
void addTimeArguments(cli::CommandLine app, SelectionOptions& selection);
void addChoiceArguments(cli::CommandLine app, SelectionOptions& selection);

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

/// The cell that a log is exported with: the one that is named, else the one that the log carries.
struct ExportCellArguments {
  std::filesystem::path cell;
  CellOptions search;
};

/// `name` is of the option or argument: "--cell", "CELL".
void addExportCellArguments(cli::CommandLine app, const char* name, ExportCellArguments& arguments);

/// Empty when none is named and the log carries none. Faults of the cell are named on standard
/// error. `geometry` reads the meshes too.
Result<std::shared_ptr<const Cell>> loadExportCell(const ExportCellArguments& arguments,
                                                   const LogReader& log, bool geometry);

}  // namespace rocinante
