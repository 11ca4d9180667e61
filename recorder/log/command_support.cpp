#include "recorder/log/command_support.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>

#include "core/base/duration_text.h"
#include "core/bundle/attached_cell.h"
#include "core/bundle/cell_or_log.h"
#include "core/cli/load_progress.h"
#include "core/cli/program.h"
#include "core/cli/search_options.h"
#include "core/cli/worker_threads.h"
#include "core/copy/copy_report.h"
#include "core/recording/compression_text.h"

namespace rocinante {

Status toStandardOutput(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size()) return {};
  return Error{ErrorKind::unreadable, "cannot write to standard output", {}};
}

Result<Nanoseconds> readEvery(const std::string& text, Nanoseconds span, std::int64_t most) {
  const Result<Nanoseconds> every = parseDuration(text);
  if (!every) return every.error();
  if (every->count() <= 0) {
    return Error{ErrorKind::bad_argument, "must be greater than zero", "--every"};
  }
  if (span / *every >= most) {
    return Error{ErrorKind::bad_argument,
                 fmt::format("more than {} moments in {}; take a longer time, or a part of it by "
                             "--from and --until",
                             most, roughDuration(span)),
                 "--every"};
  }
  return every;
}

void addCopyArguments(cli::CommandLine app, CopyArguments& arguments) {
  app.addOption("-o,--output", arguments.output, "the log to make").valueName("OUT").required();
  app.addFlag("--force", arguments.force, "replace an existing output");
  app.addOption("--compression", arguments.compression, "zstd, zstd:LEVEL (1 to 22) or none")
      .valueName("KIND")
      .showDefault();
  app.addFlag("--json", arguments.json, "print what was made as JSON");
}

void addTimeArguments(cli::CommandLine app, SelectionOptions& selection) {
  const cli::Option from =
      app.addOption("--from", selection.from, "begin at this session time (12.5s, -1s, RFC 3339)")
          .valueName("TIME");
  const cli::Option until =
      app.addOption("--until", selection.until, "end before this session time").valueName("TIME");
  app.addOption("--from-event", selection.from_event,
                "begin at the first event whose text matches; instead of --from")
      .valueName("PATTERN")
      .excludes(from);
  app.addOption("--until-event", selection.until_event,
                "end before the first matching event after that; instead of --until")
      .valueName("PATTERN")
      .excludes(until);
}

void addChoiceArguments(cli::CommandLine app, SelectionOptions& selection) {
  const auto add = [&app](const char* name, std::vector<std::string>& patterns,
                          const char* description) {
    app.addOption(name, patterns, description).valueName("PATTERN").oneEach();
  };
  add("--channel", selection.channels,
      "only topics that match this pattern; may be repeated, like those below");
  add("--not-channel", selection.not_channels, "not the topics that match");
  add("--source", selection.sources, "only packets of a SOURCE that matches");
  add("--device", selection.devices, "only packets that say something about a device that matches");
  add("--encoding", selection.encodings, "only messages of this encoding: rk1 or octets");
}

CopyProgress stoppableProgress(const std::string& doing) {
  const auto line = std::make_shared<ProgressLine>(doing);
  return [line](double part) -> Status {
    line->show(part);
    if (!cli::stopRequested()) return {};
    return Error{ErrorKind::refused, kStopped, {}};
  };
}

Result<MakeOptions> readCopyArguments(const CopyArguments& arguments) {
  MakeOptions make;
  make.output = arguments.output;
  make.overwrite = arguments.force;
  make.attachments = !arguments.without_attachments;
  if (Status read = readCompression(arguments.compression, make.log); !read) return read.error();
  return make;
}

Result<CopyReport> runCopy(const CopyArguments& arguments, const std::string& doing,
                           const std::function<Result<CopyReport>(const MakeOptions&)>& work) {
  Result<MakeOptions> make = readCopyArguments(arguments);
  if (!make) return make.error();
  cli::catchStopSignals();
  make->progress = stoppableProgress(doing);
  const cli::StopDeadline deadline(kStopped);
  return work(*make);
}

Result<cli::Exit> tellCopy(const CopyArguments& arguments, const CopyReport& report) {
  const Status printed =
      toStandardOutput(arguments.json ? copyReportJson(arguments.output, report)
                                      : copyReportText(arguments.output, report.counts));
  if (!printed) return printed.error();
  return tellGaps(report);
}

cli::Exit tellGaps(const CopyReport& report) {
  for (const CopyGap& gap : report.gaps) cli::warn(gapText(gap));
  for (const std::string& note : report.notes) cli::warn(note);
  return report.gaps.empty() && report.notes.empty() ? cli::Exit::done : cli::Exit::no;
}

void addExportCellArguments(cli::CommandLine app, const char* name,
                            ExportCellArguments& arguments) {
  const cli::Option cell =
      app.addOption(name, arguments.cell,
                    "the cell or model of the session; by default the one that the log carries");
  if (std::string_view(name).starts_with("--")) cell.valueName("CELL");
  cli::addSearchOptions(app, arguments.search);
}

Result<std::shared_ptr<const Cell>> loadExportCell(const ExportCellArguments& arguments,
                                                   const LogReader& log, bool geometry) {
  std::filesystem::path path = arguments.cell;
  if (path.empty()) {
    const std::vector<std::string> words = cli::searchWords(arguments.search);
    if (!words.empty()) return Error{ErrorKind::bad_argument, words.front() + " needs a cell", {}};
    if (!carriesCell(log)) return std::shared_ptr<const Cell>();
    path = log.name();
  }
  CellOptions options = arguments.search;
  options.geometry = geometry;
  options.parallel = cli::workerThreads();
  options.progress = cli::loadProgress(path.string());
  Result<Cell> cell = loadCellOrLog(path, options);
  if (!cell) return cell.error();
  for (const Finding& fault : cell->faults) {
    if (fault.severity == Severity::error) cli::warn(cell->shown(fault.print()));
  }
  return std::make_shared<const Cell>(std::move(*cell));
}

}  // namespace rocinante
