#include "recorder/log/export_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "core/base/count_text.h"
#include "core/cli/program.h"
#include "core/foreign/foxglove/foxglove_format.h"
#include "core/foreign/ros_out/ros2_format.h"
#include "core/report/json_text.h"
#include "recorder/copy/log_make.h"
#include "recorder/copy/log_selection.h"
#include "recorder/copy/output_file.h"
#include "recorder/export/message_export.h"
#include "recorder/export/pcap_export.h"
#include "recorder/log/command_support.h"
#include "recorder/log/copy_options.h"
#include "recorder/log/export_cell.h"

namespace rocinante {
namespace {

struct ExportArguments {
  std::string log;
  ExportCellArguments cell;
  bool foxglove = false;
  bool ros2 = false;
  bool pcap = false;
  bool raw = false;
  SelectionOptions times;
  std::string output;
  bool force = false;
  bool json = false;
};

/// What was made: for the user, and for scripts.
struct ExportAccount {
  std::string text;  ///< "34 messages of 3 topics"
  Json contents;
  std::vector<std::string> gaps, notes;
};

Result<ExportAccount> exportToMcap(const ExportArguments& my, const TimeRange& range,
                                   OutputFile& output) {
  Result<MomentWalk> session = MomentWalk::open(my.log);
  if (!session) return session.error();
  const auto cell = loadExportCell(my.cell, session->log(), false);
  if (!cell) return cell.error();
  const std::unique_ptr<SessionFormat> format = my.ros2 ? makeRos2Format() : makeFoxgloveFormat();
  Result<ExportedMcap> out = ExportedMcap::start(output.takeSink(), format->profile());
  if (!out) return out.error();
  MessageExportOptions options;
  options.from = range.from;
  options.until = range.until;
  options.raw = my.raw;
  options.progress = stoppableProgress("reading " + my.log);
  Result<MessageExportReport> report =
      exportMessages(*session, cell->get(), *format, *out, options);
  if (!report) return report.error();
  if (Status finished = out->finish(); !finished) return finished.error();
  ExportAccount account;
  std::uint64_t messages = 0;
  account.contents["topics"] = Json::array();
  for (const auto& [topic, facts] : out->topics()) {
    messages += facts.messages;
    account.contents["topics"].push_back(
        {{"topic", topic}, {"schema", facts.schema}, {"messages", facts.messages}});
  }
  account.text = countText(messages, "message") + " of " + countText(out->topics().size(), "topic");
  account.gaps = std::move(report->gaps);
  for (std::string& sentence : session->damage()) account.gaps.push_back(std::move(sentence));
  account.notes = std::move(report->notes);
  if (*cell == nullptr) {
    account.notes.push_back("no cell: there are no links (name one, or record with --cell)");
  }
  return account;
}

Result<ExportAccount> exportToPcap(const ExportArguments& my, const TimeRange& range,
                                   OutputFile& output) {
  Result<LogReader> log = LogReader::open(my.log);
  if (!log) return log.error();
  const std::unique_ptr<ByteSink> sink = output.takeSink();
  Bytes piece;
  constexpr std::size_t kPieceBytes = 1U << 16U;
  PcapFile file([&](ByteView bytes) -> Status {
    piece.insert(piece.end(), bytes.begin(), bytes.end());
    if (piece.size() < kPieceBytes) return {};
    Status written = sink->append(piece);
    piece.clear();
    return written;
  });
  Result<PcapExportReport> report =
      exportPcap(*log, range.from, range.until, file, stoppableProgress("reading " + my.log));
  if (!report) return report.error();
  Status closed = sink->append(piece);
  if (closed) closed = sink->close();
  if (!closed) return closed.error();
  ExportAccount account;
  account.text = countText(report->datagrams, "datagram");
  account.contents["datagrams"] = report->datagrams;
  account.gaps = std::move(report->gaps);
  for (const DamageSpan& span : log->damage()) {
    account.gaps.push_back(fmt::format("{} ({}, byte {})", span.cause, my.log, span.from));
  }
  account.notes = std::move(report->notes);
  return account;
}

Status tellExport(const ExportArguments& my, const ExportAccount& account) {
  if (!my.json) return toStandardOutput(fmt::format("{}: {}\n", my.output, account.text));
  Json json;
  json["format"] = 1;
  json["output"] = my.output;
  json.update(account.contents);
  json["gaps"] = account.gaps;
  json["notes"] = account.notes;
  return toStandardOutput(jsonText(json));
}

Result<cli::Exit> runExport(const ExportArguments& my) {
  const int forms = (my.foxglove ? 1 : 0) + (my.ros2 ? 1 : 0) + (my.pcap ? 1 : 0);
  if (forms != 1) {
    return Error{ErrorKind::bad_argument, "name one format: --foxglove, --ros2 or --pcap", {}};
  }
  if (my.pcap && (my.raw || !my.cell.cell.empty())) {
    return Error{ErrorKind::bad_argument, "a capture holds the datagrams alone: no CELL, no --raw",
                 "--pcap"};
  }
  if (Status free = checkOutput(my.output, my.force, {{my.log}}); !free) return free.error();
  TimeRange range;
  {
    const Result<LogReader> log = LogReader::open(my.log);
    if (!log) return log.error();
    if (Status known = knownFormat(*log); !known) return known.error();
    const Result<TimeRange> named = rangeOf(my.times, log->summary(), {});
    if (!named) return named.error();
    range = *named;
  }
  cli::catchStopSignals();
  const cli::StopDeadline deadline(kStopped);
  Result<OutputFile> output = OutputFile::create(my.output, my.force, {{my.log}});
  if (!output) return output.error();
  const Result<ExportAccount> account =
      my.pcap ? exportToPcap(my, range, *output) : exportToMcap(my, range, *output);
  if (!account) return output->named(account.error());
  if (Status named = output->commit(); !named) return named.error();
  if (Status told = tellExport(my, *account); !told) return told.error();
  for (const std::string& sentence : account->notes) cli::warn(sentence);
  for (const std::string& sentence : account->gaps) cli::warn(sentence);
  return account->gaps.empty() ? cli::Exit::done : cli::Exit::no;
}

}  // namespace

LogCommand addExportCommand(CLI::App& program) {
  auto my = std::make_shared<ExportArguments>();
  CLI::App* const app =
      program.add_subcommand("export", "write a log for other tools: Foxglove, ROS 2, captures");
  app->add_option("LOG", my->log, "the log to read")->required();
  addExportCellArguments(*app, "CELL", my->cell);
  app->add_flag("--foxglove", my->foxglove, "an MCAP file of protobuf messages of foxglove");
  app->add_flag("--ros2", my->ros2, "a ROS 2 bag: an MCAP file of CDR messages");
  app->add_flag("--pcap", my->pcap, "a capture of the datagrams, with nanoseconds");
  app->add_flag("--raw", my->raw, "the datagrams too, beside the messages");
  app->add_option("--from", my->times.from, "begin at this session time (12.5s, -1s, RFC 3339)")
      ->type_name("TIME");
  app->add_option("--until", my->times.until, "end before this session time")->type_name("TIME");
  app->add_option("-o,--output", my->output, "the file to make")->type_name("OUT")->required();
  app->add_flag("--force", my->force, "replace an existing output");
  app->add_flag("--json", my->json, "print what was made as JSON");
  return {app, [my] { return runExport(*my); }};
}

}  // namespace rocinante
