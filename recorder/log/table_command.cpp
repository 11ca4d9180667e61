#include <fmt/format.h>

#include <optional>

#include "core/base/duration_text.h"
#include "core/base/figure_text.h"
#include "core/cli/opened_session.h"
#include "core/cli/program.h"
#include "core/copy/log_selection.h"
#include "core/copy/output_file.h"
#include "core/report/json_text.h"
#include "core/session/session_time.h"
#include "recorder/export/exports.h"
#include "recorder/log/command_support.h"
#include "recorder/log/commands.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

/// A day at 1 kHz.
constexpr std::int64_t kMostRows = 100'000'000;

struct TableArguments {
  std::string log;
  std::vector<std::string> devices;
  SelectionOptions times;
  std::string every;
  bool changes = false;
  bool signals = false;
  bool clearance = false;
  std::vector<std::string> links;
  std::string frame;
  std::vector<std::string> derived;
  ExportCellArguments cell;
  std::string output;
  bool force = false;
  bool json = false;
};

enum class TableForm { csv, npy, npz };

Result<TableForm> formOf(const std::string& output) {
  const std::string ending = fs::path(output).extension().string();
  if (output.empty() || output == "-" || ending == ".csv") return TableForm::csv;
  if (ending == ".npy") return TableForm::npy;
  if (ending == ".npz") return TableForm::npz;
  return Error{ErrorKind::bad_argument, "a table is a .csv, a .npy or a .npz file", output};
}

Result<TableOptions> readTableOptions(const TableArguments& arguments, const LogSummary& log) {
  const Result<TimeRange> range = rangeOf(arguments.times, log, {});
  if (!range) return range.error();
  TableOptions options;
  options.from = range->from;
  options.until = range->until;
  if (arguments.changes) options.rows = TableOptions::Rows::changed;
  if (arguments.every.empty()) return options;
  options.rows = TableOptions::Rows::grid;
  options.from = std::max(options.from, log.start);
  options.until = std::min(options.until, std::min(log.end, kLastLogTime) + Nanoseconds(1));
  const Result<Nanoseconds> every =
      readEvery(arguments.every, options.until - options.from, kMostRows);
  if (!every) return every.error();
  options.every = *every;
  return options;
}

Result<TableReport> writeTo(const TableArguments& arguments, TableForm form, MomentWalk& session,
                            SessionTable& table, TableOptions options) {
  if (arguments.output.empty() || arguments.output == "-") {
    const auto writer =
        makeCsvTable([](ByteView bytes) { return toStandardOutput(textOf(bytes)); });
    return writeTable(session, table, *writer, options);
  }
  Result<OutputFile> output =
      OutputFile::create(arguments.output, arguments.force, {{arguments.log}});
  if (!output) return output.error();
  const std::unique_ptr<ByteSink> sink = output->takeSink();
  std::unique_ptr<TableWriter> writer;
  if (form == TableForm::npy) {
    writer = makeNpyTable(*sink);
  } else if (form == TableForm::npz) {
    const fs::path folder = fs::path(arguments.output).parent_path();
    writer = makeNpzTable(*sink, folder.empty() ? "." : folder.string());
  } else {
    writer = makeCsvTable([&](ByteView bytes) { return sink->append(bytes); });
  }
  Result<TableReport> report = writeTable(session, table, *writer, options);
  if (!report) return output->named(report.error());
  Status done = sink->close();
  if (done) done = output->commit();
  if (!done) return output->named(done.error());
  return report;
}

Status tellTable(const TableArguments& arguments, const TableReport& report,
                 const std::vector<std::string>& gaps) {
  if (arguments.output.empty() || arguments.output == "-") return {};
  if (!arguments.json) {
    return toStandardOutput(fmt::format("{}: {} of {} and the time\n", arguments.output,
                                        countText(report.rows, "row"),
                                        countText(report.columns.size(), "column")));
  }
  Json json;
  json["format"] = 1;
  json["output"] = arguments.output;
  json["rows"] = report.rows;
  json["columns"] = report.columns;
  json["gaps"] = gaps;
  json["left_out"] = leftOutJson(report.left_out);
  return toStandardOutput(jsonText(json));
}

Result<std::optional<ClearanceColumns>> clearancesOf(const TableArguments& arguments,
                                                     const Cell* cell) {
  std::optional<ClearanceColumns> columns;
  if (!arguments.clearance) return columns;
  if (cell == nullptr) {
    return Error{ErrorKind::bad_argument, "needs a cell: the log carries none, --cell CELL",
                 "--clearance"};
  }
  if (cell->clearances.empty()) {
    return Error{ErrorKind::bad_argument, "the cell has no [[clearance]]", "--clearance"};
  }
  columns.emplace(*cell, arguments.devices);
  return columns;
}

Result<std::optional<LinkColumns>> linksOf(const TableArguments& arguments, const Cell* cell,
                                           MomentWalk& session, LogTime until) {
  std::optional<LinkColumns> columns;
  if (arguments.links.empty()) return columns;
  if (cell == nullptr) {
    return Error{ErrorKind::bad_argument, "needs a cell: the log carries none, --cell CELL",
                 "--link"};
  }
  Result<LinkColumns> made =
      LinkColumns::of(*cell, arguments.links, arguments.frame, session, until);
  if (!made) return made.error();
  columns.emplace(*std::move(made));
  return columns;
}

Result<std::optional<DerivedColumns>> derivedOf(const TableArguments& arguments, const Cell* cell,
                                                MomentWalk& session) {
  std::optional<DerivedColumns> columns;
  if (arguments.derived.empty()) return columns;
  Result<DerivedColumns> made = DerivedColumns::of(cell, arguments.derived, arguments.log, session);
  if (!made) return made.error();
  columns.emplace(*std::move(made));
  return columns;
}

Result<cli::Exit> runTable(TableArguments arguments) {
  const Result<TableForm> form = formOf(arguments.output);
  if (!form) return form.error();
  const bool to_output = arguments.output.empty() || arguments.output == "-";
  if (arguments.json && to_output) {
    return Error{ErrorKind::bad_argument, "needs -o FILE: the table itself goes to standard output",
                 "--json"};
  }
  if (!to_output) {
    if (Status free = checkOutput(arguments.output, arguments.force, {{arguments.log}}); !free)
      return free.error();
  }
  const auto opened = cli::openSession(arguments.log, arguments.cell.cell);
  if (!opened) return opened.error();
  arguments.log = opened->log.string();
  Result<MomentWalk> session = MomentWalk::open(arguments.log);
  if (!session) return session.error();
  Result<TableOptions> options = readTableOptions(arguments, session->log().summary());
  if (!options) return options.error();
  const auto cell = loadExportCell(arguments.cell, session->log(), arguments.clearance);
  if (!cell) return cell.error();
  Result<std::optional<ClearanceColumns>> clearances = clearancesOf(arguments, cell->get());
  if (!clearances) return clearances.error();
  if (*clearances) options->clearances = &**clearances;
  Result<std::optional<LinkColumns>> links =
      linksOf(arguments, cell->get(), *session, session->log().summary().end);
  if (!links) return links.error();
  if (*links) options->links = &**links;
  Result<std::optional<DerivedColumns>> derived = derivedOf(arguments, cell->get(), *session);
  if (!derived) return derived.error();
  if (*derived) options->derived = &**derived;
  cli::catchStopSignals();
  options->progress = stoppableProgress("reading " + arguments.log);
  const cli::StopDeadline deadline(kStopped);
  options->signals = arguments.signals;
  SessionTable table(cell->get(), arguments.devices, arguments.signals);
  const Result<TableReport> report = writeTo(arguments, *form, *session, table, *options);
  if (!report) return report.error();
  std::vector<std::string> gaps = table.gaps();
  if (*clearances) {
    for (std::string& sentence : (*clearances)->gaps()) gaps.push_back(std::move(sentence));
  }
  for (std::string& sentence : session->damage()) gaps.push_back(std::move(sentence));
  if (Status printed = tellTable(arguments, *report, gaps); !printed) return printed.error();
  for (const std::string& sentence : table.remarks()) cli::warn(sentence);
  for (const std::string& sentence : gaps) cli::warn(sentence);
  if (!report->left_out.empty()) cli::warn(accountSentence(report->left_out));
  cli::warnOfAccount(arguments.log, cell->get());
  return gaps.empty() ? cli::Exit::done : cli::Exit::no;
}

}  // namespace

cli::Subcommand addTableCommand(cli::CommandLine program) {
  auto arguments = std::make_shared<TableArguments>();
  const cli::CommandLine app =
      program.addSubcommand("table", "write joint values and poses as columns: CSV or NumPy");
  app.addOption("LOG", arguments->log, "the log to read").required();
  app.addOption("--device", arguments->devices,
                "only devices that match this pattern; may be repeated")
      .valueName("PATTERN")
      .oneEach();
  const cli::Option every =
      app.addOption("--every", arguments->every,
                    "a row at each multiple of this time; by default one for each moment that "
                    "writes a value")
          .valueName("TIME");
  app.addFlag("--changes", arguments->changes, "only rows that differ from the one before")
      .excludes(every);
  app.addFlag("--signals", arguments->signals,
              "numbers and booleans of signals too, a column for each: `signal PATH NAME`");
  const cli::Option link =
      app.addOption("--link", arguments->links,
                    "the pose of this link too, by the cell: DEVICE/LINK:x to :qw; may be repeated")
          .valueName("PATH")
          .oneEach();
  app.addOption("--in", arguments->frame,
                "those poses in the frame of this device or link; by default in the world")
      .valueName("PATH")
      .needs(link);
  app.addOption(
         "--derive", arguments->derived,
         "what is derived too: d/dt VALUE, mean SECONDS VALUE, VALUE - VALUE; may be repeated")
      .valueName("VALUE")
      .oneEach();
  app.addFlag("--clearance", arguments->clearance,
              "the distances of the cell's clearances too, in metres, a column for each pair");
  app.addOption("--from", arguments->times.from,
                "begin at this session time (12.5s, -1s, RFC 3339)")
      .valueName("TIME");
  app.addOption("--until", arguments->times.until, "end before this session time")
      .valueName("TIME");
  addExportCellArguments(app, "--cell", arguments->cell);
  app.addOption("-o,--output", arguments->output,
                "a .csv, .npy or .npz file; by default CSV on standard output")
      .valueName("OUT");
  app.addFlag("--force", arguments->force, "replace an existing output");
  app.addFlag("--json", arguments->json, "print what was made as JSON");
  return {app, [arguments] { return runTable(*arguments); }};
}

}  // namespace rocinante
