#include "golden/run_command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <thread>

#include "core/atomic_file.h"
#include "golden/compare_command.h"
#include "golden/report.h"
#include "golden/suite_jobs.h"
#include "golden/why/frame_explainer.h"
#include "golden/why/frame_why.h"

namespace rocinante {
namespace {

Status writeOutputs(const SuiteReport& report, const RunArguments& arguments) {
  if (!arguments.junit.empty()) {
    if (auto status = writeFileWhole(arguments.junit, bytesOf(reportJunit(report)), true);
        !status) {
      return status;
    }
  }
  if (arguments.json_file == "-") {
    std::cout << reportJson(report);
  } else if (!arguments.json_file.empty()) {
    if (auto status = writeFileWhole(arguments.json_file, bytesOf(reportJson(report)), true);
        !status) {
      return status;
    }
  }
  if (!arguments.report.empty()) return writeReport(report, arguments.report);
  return {};
}

void printFrame(const JudgedFrame& judged) {
  fmt::print("{:<13} {}: {}\n", nameOf(judged.verdict), judged.frame.name, judged.rule);
  if (judged.verdict != FrameVerdict::different || !judged.drawn || !judged.accepted) return;
  for (const std::string& line : differenceMap(*judged.drawn, *judged.accepted)) {
    fmt::print("    |{}|\n", line);
  }
}

void printCounts(const SuiteReport& report) {
  fmt::print("{} frames: {} same, {} different, {} missing, {} unstable, {} incomparable",
             report.frames.size(), report.count(FrameVerdict::same),
             report.count(FrameVerdict::different), report.count(FrameVerdict::missing),
             report.count(FrameVerdict::unstable), report.count(FrameVerdict::incomparable));
  for (const FrameVerdict verdict : {FrameVerdict::expected, FrameVerdict::unexpected}) {
    if (const std::size_t count = report.count(verdict); count > 0) {
      fmt::print(", {} {}", count, nameOf(verdict));
    }
  }
  fmt::print("\n");
}

/// A key says the renderer, then size and samples.
std::string rendererOf(const std::vector<JudgedFrame>& frames) {
  for (const JudgedFrame& judged : frames) {
    if (!judged.key.empty()) return judged.key.substr(0, judged.key.find(' '));
  }
  return {};
}

SuiteReport reportOf(const SuiteSession& session, const SuiteArguments& arguments) {
  SuiteReport report;
  report.suite = arguments.suite.string();
  report.cell = session.suite().cell.lexically_normal().string();
  if (session.suite().log) report.log = session.suite().log->lexically_normal().string();
  report.session = session.sessionHash();
  report.made_at = nowText();
  report.run_command = commandText("run", arguments);
  report.approve_command = commandText("approve", arguments) + " -m 'WHY'";
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

/// Says why, a few lines a frame that failed.
void printWhy(const std::vector<JudgedFrame>& frames) {
  for (const JudgedFrame& judged : frames) {
    if (!judged.why) continue;
    fmt::print("why {}:\n", judged.frame.name);
    for (const std::string& line : whyLines(*judged.why)) fmt::print("    {}\n", line);
  }
}

Result<std::vector<JudgedFrame>> judgeFrames(SuiteSession& session, int jobs, bool quiet) {
  const std::size_t frames = session.frames().size();
  const bool progress = ::isatty(STDERR_FILENO) == 1 && frames > 8;
  JobOptions options;
  options.jobs = jobs > 0 ? jobs : usefulJobs(frames, std::thread::hardware_concurrency());
  options.stop = cli::stopRequested;
  if (!quiet) options.tell = printFrame;
  if (progress) {
    options.progress = [](std::size_t done, std::size_t of) {
      fmt::print(stderr, "\r{}/{} ", done, of);
      if (done == of) fmt::print(stderr, "\r              \r");
    };
  }
  return judgeAll(session, options);
}

}  // namespace

CLI::App* addRunCommand(CLI::App& app, RunArguments& arguments) {
  CLI::App* command = app.add_subcommand("run", "draw every case and judge it");
  addSuiteOptions(*command, arguments.suite);
  command->add_option("-j,--jobs", arguments.jobs, "processes that draw; 0: as many as pay")
      ->check(CLI::Range(0, 64))
      ->capture_default_str();
  command->add_option("--report", arguments.report, "folder for index.html and the pictures");
  command->add_option("--junit", arguments.junit, "write JUnit XML");
  command
      ->add_option("--json", arguments.json_file,
                   "write the verdicts as JSON; - is standard output")
      ->expected(0, 1)
      ->default_str("-");
  return command;
}

Result<cli::Exit> runRunCommand(const RunArguments& arguments) {
  const auto options = suiteOptions(arguments.suite);
  if (!options.ok()) return options.error();
  auto session = SuiteSession::open(arguments.suite.suite, *options);
  if (!session.ok()) return session.error();
  warnOfModelFaults(session->cell());
  const bool quiet = arguments.json_file == "-";
  SuiteReport report = reportOf(*session, arguments.suite);
  auto judged = judgeFrames(*session, arguments.jobs, quiet);
  if (!judged.ok()) return judged.error();
  report.frames = std::move(*judged);
  report.renderer = rendererOf(report.frames);
  FrameExplainer explainer(*session, arguments.suite.suite, *options);
  if (auto explained = explainFailures(explainer, report.frames); !explained) {
    return explained.error();
  }
  if (!quiet) printWhy(report.frames);
  if (auto written = writeOutputs(report, arguments); !written) return written.error();
  if (!quiet) {
    printCounts(report);
    if (!arguments.report.empty()) fmt::print("report: {}/index.html\n", arguments.report);
  }
  return exitOf(report.verdict());
}

}  // namespace rocinante
