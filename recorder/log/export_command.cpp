#include <fmt/format.h>

#include <algorithm>

#include "core/base/duration_text.h"
#include "core/base/figure_text.h"
#include "core/check/check.h"
#include "core/cli/help_formatter.h"
#include "core/cli/opened_session.h"
#include "core/cli/program.h"
#include "core/copy/log_make.h"
#include "core/copy/log_selection.h"
#include "core/copy/output_file.h"
#include "core/foreign/foxglove/foxglove_format.h"
#include "core/foreign/recordings/cell_and_log.h"
#include "core/log/damage_text.h"
#include "core/report/account.h"
#include "core/report/json_text.h"
#include "recorder/export/exports.h"
#include "recorder/log/command_support.h"
#include "recorder/log/commands.h"
#include "recorder/ros_out/ros2_format.h"

namespace rocinante {
namespace {

/// Of a scene: an hour and a half at 2 kHz.
constexpr std::int64_t kMostKeys = 10'000'000;

struct ExportArguments {
  std::string log;
  ExportCellArguments cell;
  bool foxglove = false;
  bool ros2 = false;
  bool pcap = false;
  bool gltf = false;
  std::string every;
  bool raw = false;
  bool model = false;
  bool findings = false;
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
  Account left_out;
  std::shared_ptr<const Cell> cell{};  ///< that was used; may be null
};

/// What `check` finds, at the first time of each; what has no time, at the span's beginning.
Result<std::vector<TimedNote>> findingsOf(const ExportArguments& arguments, const Cell& cell,
                                          LogTime from) {
  Result<LogReader> log = LogReader::open(arguments.log);
  if (!log) return log.error();
  const auto tell = stoppableProgress("checking " + arguments.log);
  Status stopped;
  const Result<CheckReport> report = checkLog(cell, *log, [&](double part) {
    if (stopped) stopped = tell(part);
    return stopped.ok();
  });
  if (!stopped) return stopped.error();
  if (!report) return report.error();
  std::vector<TimedNote> notes;
  for (const Finding& finding : report->findings) {
    const EventLevel level = finding.severity == Severity::error     ? EventLevel::error
                             : finding.severity == Severity::warning ? EventLevel::warning
                                                                     : EventLevel::info;
    std::string text = cell.shown(sentenceOf(finding));
    if (finding.count > 1 && finding.left_out.empty())
      text += fmt::format(" ({} times)", finding.count);
    notes.push_back({finding.first.value_or(std::max(from, log->summary().start)), level,
                     finding.rule, std::move(text)});
  }
  return notes;
}

Result<ExportAccount> exportToMcap(const ExportArguments& arguments, const TimeRange& range,
                                   OutputFile& output) {
  Result<MomentWalk> session = MomentWalk::open(arguments.log);
  if (!session) return session.error();
  const auto cell =
      loadExportCell(arguments.cell, session->log(), arguments.model || arguments.findings);
  if (!cell) return cell.error();
  if (*cell == nullptr && (arguments.model || arguments.findings)) {
    return Error{ErrorKind::bad_argument, "needs a cell: name one, or record with --cell",
                 arguments.model ? "--model" : "--findings"};
  }
  const std::unique_ptr<SessionFormat> format =
      arguments.ros2 ? makeRos2Format() : makeFoxgloveFormat();
  Result<ExportedMcap> out = ExportedMcap::start(output.takeSink(), format->profile());
  if (!out) return out.error();
  MessageExportOptions options;
  options.from = range.from;
  options.until = range.until;
  options.raw = arguments.raw;
  options.shapes = arguments.model;
  if (arguments.findings) {
    Result<std::vector<TimedNote>> found = findingsOf(arguments, **cell, range.from);
    if (!found) return found.error();
    options.notes = std::move(*found);
  }
  options.progress = stoppableProgress("reading " + arguments.log);
  Result<MessageExportReport> report =
      exportMessages(*session, cell->get(), *format, *out, options);
  if (!report) return report.error();
  if (Status finished = out->finish(); !finished) return finished.error();
  ExportAccount account;
  account.cell = *cell;
  std::uint64_t messages = 0;
  account.contents["topics"] = Json::array();
  for (const auto& [topic, facts] : out->topics()) {
    messages += facts.messages;
    account.contents["topics"].push_back(
        {{"topic", topic}, {"schema", facts.schema}, {"messages", facts.messages}});
  }
  account.text = countText(messages, "message") + " of " + countText(out->topics().size(), "topic");
  for (const std::string& gap : report->gaps) {
    account.gaps.push_back(*cell == nullptr ? gap : (*cell)->shown(gap));
  }
  for (std::string& sentence : session->damage()) account.gaps.push_back(std::move(sentence));
  account.left_out = std::move(report->left_out);
  if (*cell == nullptr) {
    account.notes.push_back("no cell: there are no links (name one, or record with --cell)");
  }
  return account;
}

Result<ExportAccount> exportToPcap(const ExportArguments& arguments, const TimeRange& range,
                                   OutputFile& output) {
  Result<LogReader> log = LogReader::open(arguments.log);
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
  Result<PcapExportReport> report = exportPcap(*log, range.from, range.until, file,
                                               stoppableProgress("reading " + arguments.log));
  if (!report) return report.error();
  Status closed = sink->append(piece);
  if (closed) closed = sink->close();
  if (!closed) return closed.error();
  ExportAccount account;
  account.text = countText(report->datagrams, "datagram");
  account.contents["datagrams"] = report->datagrams;
  account.gaps = std::move(report->gaps);
  for (const DamageSpan& span : log->damage()) {
    account.gaps.push_back(damageText(span, arguments.log));
  }
  account.notes = std::move(report->notes);
  account.left_out = std::move(report->left_out);
  return account;
}

Result<ExportAccount> exportToGltf(const ExportArguments& arguments, const TimeRange& range,
                                   OutputFile& output) {
  GltfExportOptions options;
  options.from = range.from;
  options.until = range.until;
  Result<MomentWalk> session = MomentWalk::open(arguments.log);
  if (!session) return session.error();
  if (!arguments.every.empty()) {
    const LogSummary& log = session->log().summary();
    const Nanoseconds span = std::min(range.until, log.end) - std::max(range.from, log.start);
    const Result<Nanoseconds> every = readEvery(arguments.every, span, kMostKeys);
    if (!every) return every.error();
    options.every = *every;
  }
  const auto cell = loadExportCell(arguments.cell, session->log(), true);
  if (!cell) return cell.error();
  if (*cell == nullptr) {
    return Error{ErrorKind::bad_argument, "a scene needs a cell: name one, or record with --cell",
                 "--gltf"};
  }
  const std::string folder = output.path().parent_path().string();
  Result<GltfRecording> recording = GltfRecording::make(folder.empty() ? "." : folder);
  if (!recording) return recording.error();
  options.progress = stoppableProgress("reading " + arguments.log);
  ExportAccount account;
  account.cell = *cell;
  if (Status done = recordGltf(*session, **cell, *recording, options, account.left_out); !done) {
    return done.error();
  }
  const std::unique_ptr<ByteSink> sink = output.takeSink();
  Result<GltfRecording::Facts> facts = recording->write(*sink);
  if (!facts) return facts.error();
  if (Status closed = sink->close(); !closed) return closed.error();
  account.text = fmt::format("{}, {}, {} over {:.3f} s", countText(facts->nodes, "node"),
                             countText(facts->triangles, "triangle"), countText(facts->keys, "key"),
                             facts->seconds);
  account.contents["nodes"] = facts->nodes;
  account.contents["meshes"] = facts->meshes;
  account.contents["cameras"] = facts->cameras;
  account.contents["triangles"] = facts->triangles;
  account.contents["channels"] = facts->channels;
  account.contents["keys"] = facts->keys;
  account.contents["seconds"] = facts->seconds;
  for (const std::string& gap : facts->gaps) account.gaps.push_back((*cell)->shown(gap));
  for (std::string& sentence : session->damage()) account.gaps.push_back(std::move(sentence));
  account.notes = std::move(facts->notes);
  return account;
}

Status tellExport(const ExportArguments& arguments, const ExportAccount& account) {
  if (!arguments.json)
    return toStandardOutput(fmt::format("{}: {}\n", arguments.output, account.text));
  Json json;
  json["format"] = 1;
  json["output"] = arguments.output;
  json.update(account.contents);
  json["gaps"] = account.gaps;
  json["notes"] = account.notes;
  json["left_out"] = leftOutJson(account.left_out);
  return toStandardOutput(jsonText(json));
}

Status checkExport(const ExportArguments& arguments) {
  const auto bad = [](const char* what, const char* where) -> Status {
    return Error{ErrorKind::bad_argument, what, where};
  };
  const int forms = (arguments.foxglove ? 1 : 0) + (arguments.ros2 ? 1 : 0) +
                    (arguments.pcap ? 1 : 0) + (arguments.gltf ? 1 : 0);
  if (forms != 1) return bad("name one format: --foxglove, --ros2, --pcap or --gltf", "");
  if (arguments.model && !arguments.foxglove) return bad("needs --foxglove", "--model");
  if (arguments.findings && !arguments.foxglove && !arguments.ros2) {
    return bad("needs --foxglove or --ros2", "--findings");
  }
  if (arguments.pcap && (arguments.raw || !arguments.cell.cell.empty())) {
    return bad("a capture holds the datagrams alone: no CELL, no --raw", "--pcap");
  }
  if (!arguments.gltf) return arguments.every.empty() ? Status{} : bad("needs --gltf", "--every");
  if (arguments.raw) return bad("a scene holds no datagrams: no --raw", "--gltf");
  if (std::filesystem::path(arguments.output).extension() != ".glb") {
    return bad("the scene's name must end with .glb", arguments.output.c_str());
  }
  return {};
}

Result<cli::Exit> runExport(ExportArguments arguments) {
  if (Status fit = checkExport(arguments); !fit) return fit.error();
  if (Status free = checkOutput(arguments.output, arguments.force, {{arguments.log}}); !free)
    return free.error();
  const auto opened = cli::openSession(arguments.log, arguments.cell.cell);
  if (!opened) return opened.error();
  arguments.log = opened->log.string();
  TimeRange range;
  {
    const Result<LogReader> log = LogReader::open(arguments.log);
    if (!log) return log.error();
    if (Status known = knownFormat(*log); !known) return known.error();
    const Result<TimeRange> named = rangeOf(arguments.times, log->summary(), {});
    if (!named) return named.error();
    range = *named;
  }
  cli::catchStopSignals();
  const cli::StopDeadline deadline(kStopped);
  Result<OutputFile> output =
      OutputFile::create(arguments.output, arguments.force, {{arguments.log}});
  if (!output) return output.error();
  const Result<ExportAccount> account = arguments.pcap   ? exportToPcap(arguments, range, *output)
                                        : arguments.gltf ? exportToGltf(arguments, range, *output)
                                                         : exportToMcap(arguments, range, *output);
  if (!account) return output->named(account.error());
  if (Status named = output->commit(); !named) return named.error();
  if (Status printed = tellExport(arguments, *account); !printed) return printed.error();
  for (const std::string& sentence : account->notes) cli::warn(sentence);
  for (const std::string& sentence : account->gaps) cli::warn(sentence);
  if (!account->left_out.empty()) cli::warn(accountSentence(account->left_out));
  cli::warnOfAccount(arguments.log, account->cell.get());
  return account->gaps.empty() ? cli::Exit::done : cli::Exit::no;
}

}  // namespace

cli::Subcommand addExportCommand(cli::CommandLine program) {
  auto arguments = std::make_shared<ExportArguments>();
  const cli::CommandLine app = program.addSubcommand(
      "export", "write a log for other tools: Foxglove, ROS 2, captures, glTF");
  addExportCellArguments(app, "CELL", arguments->cell);
  app.addOption("LOG", arguments->log, "the log to read").showRequired();
  app.addFlag("--foxglove", arguments->foxglove, "an MCAP file of protobuf messages of foxglove");
  app.addFlag("--ros2", arguments->ros2, "a ROS 2 bag: an MCAP file of CDR messages");
  app.addFlag("--pcap", arguments->pcap, "a capture of the datagrams, with nanoseconds");
  app.addFlag("--gltf", arguments->gltf,
              "a .glb: the cell's scene, animated as the session moved it");
  app.addOption("--every", arguments->every,
                "of --gltf: keys at each multiple of this time; by default at every moment that "
                "writes a value")
      .valueName("TIME");
  app.addFlag("--raw", arguments->raw, "the datagrams too, beside the messages");
  app.addFlag("--model", arguments->model,
              "of --foxglove: what every link shows, as glTF in the messages");
  app.addFlag("--findings", arguments->findings, "what `check` finds too, among the events");
  app.addOption("--from", arguments->times.from,
                "begin at this session time (12.5s, -1s, RFC 3339)")
      .valueName("TIME");
  app.addOption("--until", arguments->times.until, "end before this session time")
      .valueName("TIME");
  app.addOption("-o,--output", arguments->output, "the file to make").valueName("OUT").required();
  app.addFlag("--force", arguments->force, "replace an existing output");
  app.addFlag("--json", arguments->json, "print what was made as JSON");
  return {app, [arguments]() -> Result<cli::Exit> {
            std::filesystem::path log = arguments->log;
            if (Status has = orderLogAndItsCell(arguments->cell.cell, log); !has)
              return has.error();
            arguments->log = log.string();
            return runExport(*arguments);
          }};
}

}  // namespace rocinante
