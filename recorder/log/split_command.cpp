
#include "core/base/duration_text.h"
#include "core/base/figure_text.h"
#include "core/copy/copy_report.h"
#include "core/copy/log_split.h"
#include "recorder/log/command_support.h"
#include "recorder/log/commands.h"

namespace rocinante {
namespace {

constexpr std::uint64_t kLeastPieceBytes = 4096;

struct SplitArguments {
  std::string log;
  std::string size;
  std::string time;
  SplitOptions split;
  CopyArguments copy;
};

Result<std::uint64_t> readSize(const std::string& text) {
  Result<std::uint64_t> size = parseSize(text);
  if (size && *size < kLeastPieceBytes) {
    return Error{ErrorKind::bad_argument, "a piece must be at least 4096 bytes", text};
  }
  return size;
}

Result<SplitReport> split(SplitArguments& arguments) {
  Result<MakeOptions> make = readCopyArguments(arguments.copy);
  if (!make) return make.error();
  if (!arguments.size.empty()) {
    const Result<std::uint64_t> size = readSize(arguments.size);
    if (!size) return size.error();
    arguments.split.size_bytes = *size;
  }
  if (!arguments.time.empty()) {
    const Result<Nanoseconds> time = parseDuration(arguments.time);
    if (!time) return time.error();
    if (*time <= Nanoseconds(0)) {
      return Error{ErrorKind::bad_argument, "--time must be greater than zero", arguments.time};
    }
    arguments.split.time = *time;
  }
  cli::catchStopSignals();
  make->progress = stoppableProgress("reading " + arguments.log);
  const cli::StopDeadline deadline(kStopped);
  return splitLog(arguments.log, arguments.split, *make);
}

Result<cli::Exit> runSplit(SplitArguments& arguments) {
  const Result<SplitReport> report = split(arguments);
  if (!report) return report.error();
  std::string text;
  if (arguments.copy.json) {
    text = splitReportJson(*report);
  } else {
    for (const SplitPiece& piece : report->pieces) {
      text += copyReportText(piece.path.string(), piece.counts);
    }
  }
  if (Status printed = toStandardOutput(text); !printed) return printed.error();
  return tellGaps(report->whole);
}

}  // namespace

cli::Subcommand addSplitCommand(cli::CommandLine program) {
  auto arguments = std::make_shared<SplitArguments>();
  const cli::CommandLine app =
      program.addSubcommand("split", "split a log into self-contained pieces");
  app.addOption("LOG", arguments->log, "the log; it is not changed").required();
  const cli::CommandLine where = app.addOneOf("where", "Where to split (one of these)");
  where.addOption("--size", arguments->size, "pieces of about this size (100MB, 64MiB)")
      .valueName("SIZE");
  where
      .addOption("--time", arguments->time,
                 "pieces of this length (60s), counted from the session's origin")
      .valueName("TIME");
  where
      .addOption("--event", arguments->split.event,
                 "a new piece from each event whose text matches")
      .valueName("PATTERN");
  app.addFlag("--attach-once", arguments->split.attach_once,
              "put attachments into the first piece only");
  addCopyArguments(app, arguments->copy);
  app.option("--output")
      .description(
          "a folder, or the pieces' name, in which %n is the number (without %n it goes before the "
          "extension)")
      .valueName("NAME");
  return {app, [arguments] { return runSplit(*arguments); }};
}

}  // namespace rocinante
