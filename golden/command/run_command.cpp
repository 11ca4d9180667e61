#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <thread>
#include <tuple>

#include "core/base/atomic_file.h"
#include "core/base/hash.h"
#include "core/base/plain_text.h"
#include "core/cli/progress_line.h"
#include "core/cli/terminal.h"
#include "core/cli/text_table.h"
#include "core/cli/worker_threads.h"
#include "golden/command/commands.h"
#include "golden/command/compare_command.h"
#include "golden/command/report_output.h"
#include "golden/judge/housekeeping.h"
#include "golden/judge/suite_jobs.h"
#include "golden/judge/suite_runs.h"
#include "golden/report/cause_groups.h"
#include "golden/report/report.h"
#include "golden/report/report_runs.h"
#include "golden/suite/suite_neighbours.h"
#include "golden/why/accepted_cells.h"
#include "golden/why/explain_pictures.h"
#include "golden/why/frame_explainer.h"
#include "golden/why/frame_why.h"
#include "golden/why/run_pictures.h"

namespace rocinante {
namespace {

constexpr std::size_t kNameColumn = 14;  // of a frame's line, behind its verdict

/// Sentences are broken at a terminal's width. Below the sentence of several frames a line each is
/// enough: its end, where the limit is from, may be cut.
void printFailures(const std::vector<JudgedFrame>& frames, bool verbose) {
  const std::size_t columns = cli::outputTerminal().columns;
  for (const CauseGroup& group : causeGroups(frames)) {
    const std::size_t causes = group.sentence.empty() ? 0 : 1;
    const bool may_be_cut = !verbose && causes > 0 && group.frames.size() > 1;
    const std::vector<std::string> lines = groupLines(group, verbose);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const bool is_frame = i >= causes && !lines[i].starts_with(' ');
      fmt::print("{}\n", is_frame && may_be_cut
                             ? cli::withoutEnd(lines[i], columns)
                             : cli::wrapped(lines[i], columns, is_frame ? kNameColumn : 6));
    }
  }
}

std::vector<std::string> notesOf(const SuiteSession& session, const FrameSelection& selection,
                                 const std::vector<JudgedFrame>& judged) {
  std::vector<std::string> notes = suiteNotes(judged);
  // A partial run cannot judge the rest of the folder.
  if (!selection.isWhole()) return notes;
  for (std::string& fault :
       folderFaults(session.manifest(), session.folder(), session.allFrames(), false,
                    session.suite().runs, neighboursOf(session.suite()))) {
    notes.push_back(std::move(fault));
  }
  return notes;
}

std::string rendererOfRun(const std::vector<JudgedFrame>& frames) {
  for (const JudgedFrame& judged : frames) {
    if (!judged.key.empty()) return std::string(rendererOf(judged.key));
  }
  return {};
}

SuiteReport reportOf(const SuiteSession& session, const SuiteArguments& arguments) {
  SuiteReport report;
  report.suite = arguments.suite.string();
  report.cell = session.suite().cell.lexically_normal().string();
  if (session.suite().log) report.log = session.suite().log->lexically_normal().string();
  report.session = session.sessionHash();
  report.decoded = session.decodedHash();
  report.made_at = nowText();
  if (!arguments.shard.empty()) {
    std::tie(report.shard, report.shards) = parseShard(arguments.shard).value_or(std::pair(1, 1));
  }
  report.run_command = commandText("run", arguments);
  SuiteArguments one = arguments;
  one.shard.clear();
  one.only.clear();
  one.tags.clear();
  one.not_tags.clear();
  report.run_one_command = commandText("run", one) + " --only";
  report.approve_one_command = commandText("approve", one) + " -m 'WHY' --only";
  report.approve_from_command = commandText("approve", one) + " -m 'WHY' --from LIST";
  return report;
}

/// Keeps the logs of runs that may be accepted for the report's folder.
void keepRunLogs(const SuiteSession& session, std::vector<JudgedRun>& runs) {
  for (JudgedRun& run : runs) {
    if (run.verdict != FrameVerdict::different && run.verdict != FrameVerdict::missing) continue;
    const auto spec = std::ranges::find_if(
        session.runs(), [&](const SuiteRun* one) { return one->name == run.name; });
    const OpenedRecording* const log =
        spec == session.runs().end() ? nullptr : session.logOf(**spec);
    if (log == nullptr) continue;
    auto bytes = readFile(log->log, kMaxRunLogBytes);
    if (!bytes.ok()) continue;  // too large for a report
    run.log_bytes = hexOf(xxh3(bytesOf(*bytes)));
    run.log_copy = std::make_shared<const std::string>(std::move(*bytes));
  }
}

/// The command that accepts all that is not fine: the frames, then each run.
std::string acceptCommand(const SuiteReport& report, const SuiteArguments& arguments) {
  std::string text;
  const bool has_frames =
      !std::ranges::all_of(report.frames, isFine, &JudgedFrame::verdict) || report.shards > 1;
  if (has_frames || report.runs.empty()) {
    text = commandText("approve", arguments) + " -m 'WHY'";
    const auto isWhole = [](const JudgedFrame& frame) { return frame.lacks.empty(); };
    if (!std::ranges::all_of(report.frames, isWhole)) text += " --anyway";
  }
  SuiteArguments of_run = arguments;
  of_run.only.clear();
  of_run.tags.clear();
  of_run.not_tags.clear();
  of_run.shard.clear();
  for (const JudgedRun& run : report.runs) {
    if (run.verdict != FrameVerdict::different && run.verdict != FrameVerdict::missing) continue;
    const bool is_far = std::ranges::any_of(run.judgement.findings, widensFar);
    text +=
        fmt::format("{}{} -m 'WHY' --run {}{}", text.empty() ? "" : " && ",
                    commandText("approve", of_run), shellWord(run.name), is_far ? " --anyway" : "");
  }
  return text;
}

/// Prints all that is known of why and where each frame failed; the reasons come first because a
/// map fills a screen.
void printWhy(const std::vector<JudgedFrame>& frames) {
  for (const JudgedFrame& judged : frames) {
    if (judged.why) {
      fmt::print("why {}:\n", judged.frame.name);
      for (const std::string& line : whyLines(*judged.why)) fmt::print("    {}\n", line);
    }
    const bool has_map =
        judged.comparison.differing > 0 &&
        (judged.verdict == FrameVerdict::different || judged.verdict == FrameVerdict::incomparable);
    if (!has_map || !judged.drawn || !judged.accepted) continue;
    if (!judged.why) fmt::print("where {}:\n", judged.frame.name);
    for (const std::string& line : differenceMap(judged.compared(), *judged.accepted)) {
      fmt::print("    |{}|\n", line);
    }
  }
}

Result<std::vector<JudgedFrame>> judgeFrames(SuiteSession& session, int jobs, bool quiet) {
  const std::size_t frames = session.frames().size();
  cli::ProgressLine progress("judging");
  JobOptions options;
  options.jobs = jobs > 0 ? jobs : usefulJobs(frames, std::thread::hardware_concurrency());
  options.stop = cli::stopRequested;
  const std::size_t columns = cli::outputTerminal().columns;
  // Frames that are not fine are printed below their cause, once it is known.
  std::vector<std::string> failed;
  options.tell = [&](const JudgedFrame& judged) {
    if (quiet) return;
    if (isFine(judged.verdict)) {
      progress.clear();
      fmt::print("{}\n", cli::wrapped(frameLine(judged, judged.rule), columns, kNameColumn));
    } else {
      failed.push_back(frameLine(judged, judged.rule));
    }
  };
  options.progress = [&](std::size_t done, std::size_t of) {
    progress.show(static_cast<double>(done) / static_cast<double>(of));
  };
  auto judged = judgeAll(session, options);
  progress.clear();
  if (!judged.ok()) {
    for (const std::string& line : failed) fmt::print("{}\n", line);
  }
  return judged;
}

/// With their findings explained, and with pictures where they are wanted.
Result<std::vector<JudgedRun>> explainedRuns(const SuiteSession& session,
                                             const std::vector<const SuiteRun*>& runs,
                                             const SuiteOptions& options) {
  AcceptedCells cells(session, options);
  auto judged = judgeRuns(
      session, runs,
      {cli::stopRequested, steadyMs, TrackCache::ofUser(),
       [&](const AcceptedRun& accepted) { return cells.of(accepted); }, cli::workerThreads()});
  if (!judged.ok()) return judged;
  explainRuns(session, options, *judged);
  if (options.run_pictures) {
    for (JudgedRun& run : *judged) drawRunPictures(session, run);
  }
  return judged;
}

/// All that are selected, in suite order.
Result<std::vector<JudgedRun>> explainedRuns(const SuiteSession& session,
                                             const std::filesystem::path& suite_file,
                                             const SuiteOptions& options) {
  std::vector<const SuiteRun*> here;
  std::vector<JudgedRun> all;
  for (const SuiteRun* run : session.runs()) {
    const auto its_options = session.optionsOf(*run, options);
    if (!its_options) {
      here.push_back(run);
      continue;
    }
    const auto own = SuiteSession::open(suite_file, *its_options);
    if (!own.ok()) {
      // The others are judged all the same.
      JudgedRun unreadable;
      unreadable.name = run->name;
      unreadable.tags = run->tags;
      unreadable.place = static_cast<std::size_t>(run - session.suite().runs.data());
      unreadable.line = run->line;
      unreadable.rule = own.error().text();
      all.push_back(std::move(unreadable));
      continue;
    }
    auto judged = explainedRuns(*own, own->runs(), *its_options);
    if (!judged.ok()) return judged;
    std::ranges::move(*judged, std::back_inserter(all));
  }
  auto judged = explainedRuns(session, here, options);
  if (!judged.ok()) return judged;
  std::ranges::move(*judged, std::back_inserter(all));
  std::ranges::sort(all, {}, &JudgedRun::place);
  return all;
}

}  // namespace

cli::CommandLine addRunCommand(cli::CommandLine app, RunArguments& arguments) {
  const cli::CommandLine command = app.addSubcommand("run", "draw and judge every case");
  addSuiteOptions(command, arguments.suite);
  addIncompleteOption(command, arguments.suite);
  command
      .addOption("-j,--jobs", arguments.jobs,
                 "drawing processes; 0: chosen from the frames and processors")
      .within(0, 64)
      .showDefault();
  command.addFlag("-v,--verbose", arguments.verbose,
                  "print why each frame differs link by link, and a map of where");
  addReportFiles(command, arguments.files);
  const cli::Option pages =
      command
          .addFlag("--page", arguments.pages,
                   "with --report: a page of the session of what is not fine, which opens in a "
                   "browser at its moment")
          .needs("--report");
  command
      .addOption("--viewer", arguments.viewer,
                 "with --page: the folder of rocinante-viewer.js and .wasm; without it, the "
                 "installed one")
      .valueText("DIR")
      .needs(pages);
  return command;
}

Result<cli::Exit> runSuiteCommand(const RunArguments& arguments) {
  auto options = suiteOptions(arguments.suite);
  if (!options.ok()) return options.error();
  options->run_pictures = !arguments.files.folder.empty();
  auto session = SuiteSession::open(arguments.suite.suite, *options);
  if (!session.ok()) return session.error();
  warnOfModelFaults(session->cell());
  const bool quiet = arguments.files.json_file == "-";
  SuiteReport report = reportOf(*session, arguments.suite);
  auto judged = judgeFrames(*session, arguments.jobs, quiet);
  if (!judged.ok()) return judged.error();
  report.frames = std::move(*judged);
  FrameExplainer explainer(*session, arguments.suite.suite, *options);
  const Status explained = explainFailures(explainer, report.frames);
  if (!quiet) printFailures(report.frames, arguments.verbose);
  if (!explained) return explained.error();
  if (!quiet && arguments.verbose) printWhy(report.frames);
  auto runs = explainedRuns(*session, arguments.suite.suite, *options);
  if (!runs.ok()) return runs.error();
  report.runs = std::move(*runs);
  if (!quiet) {
    for (const JudgedRun& run : report.runs) fmt::print("{}", runText(run));
  }
  report.approve_command = acceptCommand(report, arguments.suite);
  if (!arguments.files.folder.empty()) keepRunLogs(*session, report.runs);
  report.notes = notesOf(*session, options->selection, report.frames);
  report.renderer = rendererOfRun(report.frames);
  if (arguments.pages) {
    Status added = addSessionPages(*session, arguments.suite, arguments.viewer, report);
    if (!added) return added.error();
  }
  if (!arguments.files.folder.empty() && std::ranges::any_of(report.frames, canApprove)) {
    const auto cell = collectSessionCell(*session, *options);
    if (cell.ok()) report.cell_files = hashesOf(*cell);
  }
  if (auto written = writeReportFiles(report, arguments.files); !written) return written.error();
  if (!quiet) {
    printReportSummary(report);
    if (!arguments.files.folder.empty())
      fmt::print("report: {}/index.html\n", arguments.files.folder);
  }
  return exitOf(report.verdict());
}

}  // namespace rocinante
