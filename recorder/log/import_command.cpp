#include <fmt/format.h>

#include <algorithm>

#include "core/base/duration_text.h"
#include "core/base/plain_text.h"
#include "core/bundle/attached_cell.h"
#include "core/check/log_account.h"
#include "core/cli/load_progress.h"
#include "core/cli/search_options.h"
#include "core/cli/text_table.h"
#include "core/cli/worker_threads.h"
#include "core/copy/output_file.h"
#include "core/foreign/recordings/bag_folder.h"
#include "core/foreign/recordings/capture_import.h"
#include "core/foreign/recordings/recording_kind.h"
#include "core/report/json_text.h"
#include "recorder/log/command_support.h"
#include "recorder/log/commands.h"

namespace rocinante {
namespace {

struct ImportArguments {
  std::vector<std::string> inputs;
  std::filesystem::path cell;
  CellOptions search;
  std::string device;
  CopyArguments copy;
};

/// The cell that names are looked for in, and what is attached of it.
struct GivenCell {
  Cell names;
  CellBundle bundle;
};

Result<std::optional<GivenCell>> readCell(const ImportArguments& arguments) {
  if (arguments.cell.empty()) return std::optional<GivenCell>();
  GivenCell given;
  CellOptions options = arguments.search;
  options.parallel = cli::workerThreads();
  options.progress = cli::loadProgress(arguments.cell);
  Result<CellBundle> bundle = collectCellOrLog(arguments.cell, options);
  if (!bundle) return bundle.error();
  given.bundle = std::move(*bundle);
  for (const std::string& warning : bundleWarnings(given.bundle)) cli::warn(warning);
  options.geometry = false;
  Result<Cell> names = loadCellOrLog(arguments.cell, options);
  if (!names) return names.error();
  given.names = std::move(*names);
  return std::optional(std::move(given));
}

bool isCapture(const std::filesystem::path& path) {
  return recordingKindOf(path) == RecordingKind::capture;
}

/// The inputs, with the files of each folder that is a ROS 2 bag in its place.
std::vector<std::filesystem::path> pathsOf(const std::vector<std::string>& inputs) {
  std::vector<std::filesystem::path> paths;
  for (const std::string& input : inputs) {
    const std::vector<std::filesystem::path> files = filesOfRecording(input);
    paths.insert(paths.end(), files.begin(), files.end());
  }
  return paths;
}

Result<ros::ImportReport> import(const ImportArguments& arguments, const MakeOptions& make) {
  const std::vector<std::filesystem::path> paths = pathsOf(arguments.inputs);
  if (Status free = checkOutput(make.output, make.overwrite, paths); !free) return free.error();
  const auto captures = std::ranges::count_if(paths, isCapture);
  if (captures > 0 && paths.size() > 1) {
    return Error{ErrorKind::bad_argument,
                 "a capture is imported alone; `rocinante log merge` joins logs",
                 std::ranges::find_if(paths, isCapture)->string()};
  }
  std::vector<std::unique_ptr<ros::BagReader>> bags;
  for (const std::filesystem::path& path : paths) {
    if (captures > 0) break;
    Result<std::unique_ptr<ros::BagReader>> bag = openRecording(path, arguments.device);
    if (!bag) return bag.error();
    bags.push_back(std::move(*bag));
  }
  const Result<std::optional<GivenCell>> cell = readCell(arguments);
  if (!cell) return cell.error();
  Result<std::string> session_id = ros::importedSessionId(paths);
  if (!session_id) return session_id.error();
  ros::ImportOptions options;
  options.device = arguments.device;
  std::size_t files = 0;
  for (const std::string& input : arguments.inputs) {
    const std::vector<std::string> lacks = damageOfBagFolder(input);
    options.damage.insert(options.damage.end(), lacks.begin(), lacks.end());
    const auto stated = statedOfBagFolder(input, files);
    options.stated.insert(options.stated.end(), stated.begin(), stated.end());
    files += filesOfRecording(input).size();
  }
  options.search = arguments.search;
  options.log = make.log;
  options.keyframes = make.keyframes;
  options.progress = make.progress;
  if (*cell) {
    options.cell = &(*cell)->names;
    options.bundle = &(*cell)->bundle;
  }
  Result<OutputFile> output = OutputFile::create(make.output, make.overwrite, paths);
  if (!output) return output.error();
  Result<ros::ImportReport> report =
      captures > 0
          ? importCapture(paths.front(), output->takeSink(), std::move(*session_id), options)
          : ros::importBags(std::move(bags), output->takeSink(), std::move(*session_id), options);
  if (!report) return output->named(report.error());
  if (Status named = output->commit(); !named) return named.error();
  return report;
}

/// What of the log became no packet, and what of its cell no packet moves.
std::string accountOf(const std::filesystem::path& log) {
  CellOptions options;
  options.geometry = false;
  const Result<Cell> cell = loadCellOrLog(log, options);
  const Result<LogAccount> account = logAccount(log, cell ? &*cell : nullptr);
  return account ? account->sentence() : std::string();
}

std::string becameText(const ros::ImportedTopic& topic) {
  if (!topic.translated) return "kept as they are";
  return cli::counted(topic.packets, "packet");
}

/// For the user: what was made, then one line a topic.
std::string importReportText(const std::string& output, const ros::ImportReport& report) {
  std::string text = fmt::format(
      "{}: {} of {}, {} s; {} became packets\n", plainText(output),
      cli::counted(report.messages, "message"), cli::counted(report.topics.size(), "topic"),
      secondsText(report.end - report.start, 3), cli::grouped(report.packets));
  cli::TextTable table;
  table.is_number = {false, false, true, false};
  for (const ros::ImportedTopic& topic : report.topics) {
    table.rows.push_back({plainText(topic.name), plainText(topic.type.empty() ? "-" : topic.type),
                          cli::counted(topic.messages, "message"), becameText(topic)});
  }
  text += table.text();
  if (!report.robot.empty()) {
    text += fmt::format("  the robot description is the log's cell: device {}\n",
                        plainText(report.robot));
  }
  return text;
}

/// One JSON object for scripts (docs/programs/log.md).
std::string importReportJson(const std::string& output, const ros::ImportReport& report) {
  Json topics = Json::array();
  for (const ros::ImportedTopic& topic : report.topics) {
    Json notes = Json::object();
    for (const auto& [sentence, count] : topic.notes) notes[sentence] = count;
    topics.push_back({{"topic", topic.name},
                      {"type", topic.type},
                      {"messages", topic.messages},
                      {"translated", topic.translated},
                      {"packets", topic.packets},
                      {"malformed", topic.malformed},
                      {"fault", topic.fault.empty() ? Json(nullptr) : Json(topic.fault)},
                      {"notes", std::move(notes)}});
  }
  const Json out{{"format", 1},
                 {"output", output},
                 {"messages", report.messages},
                 {"packets", report.packets},
                 {"malformed", report.malformed},
                 {"dropped", report.dropped},
                 {"lost", report.lost},
                 {"start_ns", nanosecondsOf(report.start)},
                 {"end_ns", nanosecondsOf(report.end)},
                 {"bytes", report.bytes},
                 {"robot", report.robot.empty() ? Json(nullptr) : Json(report.robot)},
                 {"topics", std::move(topics)},
                 {"damage", report.damage},
                 {"notes", report.notes},
                 {"left_out", leftOutJson(report.account)}};
  return jsonText(out);
}

Result<cli::Exit> runImport(const ImportArguments& arguments) {
  Result<MakeOptions> make = readCopyArguments(arguments.copy);
  if (!make) return make.error();
  cli::catchStopSignals();
  make->progress = stoppableProgress("importing");
  const cli::StopDeadline deadline(kStopped);
  const Result<ros::ImportReport> report = import(arguments, *make);
  if (!report) return report.error();
  const Status printed =
      toStandardOutput(arguments.copy.json ? importReportJson(arguments.copy.output, *report)
                                           : importReportText(arguments.copy.output, *report));
  if (!printed) return printed.error();
  for (const std::string& warning : ros::importWarnings(*report)) cli::warn(warning);
  const std::string account = accountOf(arguments.copy.output);
  if (!account.empty()) cli::warn(account);
  return report->lostNothing() ? cli::Exit::done : cli::Exit::no;
}

}  // namespace

cli::Subcommand addImportCommand(cli::CommandLine program) {
  auto arguments = std::make_shared<ImportArguments>();
  const cli::CommandLine app = program.addSubcommand(
      "import", "make a log of what other programs recorded, with its packets");
  app.addOption("IN", arguments->inputs,
                "ROS bags (MCAP, .db3, .bag, or the folder of one), LCM logs, CSV, JSON lines; "
                "or a capture; told by content; several become one")
      .required();
  app.addOption("--cell", arguments->cell,
                "the cell that names the devices; attached to the log. Default: the bag's "
                "robot_description")
      .valueName("CELL");
  cli::addSearchOptions(app, arguments->search);
  app.addOption("--device", arguments->device,
                "the device of joints and poses that name no device of the cell")
      .valueName("NAME");
  addCopyArguments(app, arguments->copy);
  return {app, [arguments] { return runImport(*arguments); }};
}

}  // namespace rocinante
