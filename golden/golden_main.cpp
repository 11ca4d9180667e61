// rocinante-golden: visual regression (docs/programs/golden.md).
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdlib>
#include <iostream>

#include "core/atomic_file.h"
#include "core/cli/program.h"
#include "core/duration_text.h"
#include "golden/compare_command.h"
#include "golden/report.h"
#include "golden/run_suite.h"

namespace rocinante {
namespace {

using cli::Exit;

constexpr char kExamples[] =
    "  rocinante golden run examples/demo/demo.suite.toml --report out/report\n"
    "  rocinante golden run suite.toml --log new.mcap --only 'pick*' --junit out/junit.xml\n"
    "  rocinante golden approve suite.toml --only picked -m 'the gripper got longer fingers'\n"
    "  rocinante golden compare before.png after.png --tier cpu\n";

struct Arguments {
  std::filesystem::path suite;
  std::string cell, log, only, report, junit, json_file, message;
  std::vector<std::filesystem::path> search;
  bool search_environment = false;
};

double steadyMs() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::milli>(now).count();
}

std::string nowText() {
  const auto now =
      std::chrono::time_point_cast<std::chrono::seconds>(std::chrono::system_clock::now());
  return rfc3339Text(WallTime(now.time_since_epoch())).substr(0, 19) + "Z";
}

SuiteOptions suiteOptions(const Arguments& arguments) {
  SuiteOptions options;
  if (!arguments.cell.empty()) options.cell = arguments.cell;
  if (!arguments.log.empty()) options.log = arguments.log;
  options.only = arguments.only;
  options.search = arguments.search;
  options.search_environment = arguments.search_environment;
  options.now_ms = steadyMs;
  return options;
}

/// `word` as a shell takes it for one argument.
std::string shellWord(const std::string& word) {
  const bool plain = !word.empty() && word.find_first_not_of(
                                          "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                          "0123456789_./:=@%+,-") == std::string::npos;
  if (plain) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string commandText(const char* verb, const Arguments& arguments) {
  std::string text = fmt::format("rocinante golden {} {}", verb, shellWord(arguments.suite));
  if (!arguments.cell.empty()) text += " --cell " + shellWord(arguments.cell);
  if (!arguments.log.empty()) text += " --log " + shellWord(arguments.log);
  if (!arguments.only.empty()) text += " --only " + shellWord(arguments.only);
  for (const auto& root : arguments.search) text += " --search " + shellWord(root.string());
  return text;
}

void warnOfModelFaults(const SuiteSession& session) {
  std::size_t errors = 0;
  const ModelFault* first = nullptr;
  for (const ModelFault& fault : session.modelFaults()) {
    if (fault.severity != Severity::error) continue;
    ++errors;
    if (first == nullptr) first = &fault;
  }
  if (first != nullptr) {
    cli::warn(fmt::format("the cell has {} errors (rocinante check lists them); the first: {}",
                          errors, first->print()));
  }
}

Status writeOutputs(const SuiteReport& report, const Arguments& arguments) {
  if (!arguments.junit.empty()) {
    if (auto status = writeFileWhole(arguments.junit, bytesOf(reportJunit(report)), true);
        !status) {
      return status;
    }
  }
  if (!arguments.json_file.empty()) {
    if (arguments.json_file == "-") {
      std::cout << reportJson(report);
    } else if (auto status = writeFileWhole(arguments.json_file, bytesOf(reportJson(report)), true);
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

Result<Exit> runSuite(const Arguments& arguments) {
  auto session = SuiteSession::open(arguments.suite, suiteOptions(arguments));
  if (!session.ok()) return session.error();
  warnOfModelFaults(*session);
  const bool quiet = arguments.json_file == "-";

  SuiteReport report;
  report.suite = arguments.suite.string();
  report.cell = session->suite().cell.lexically_normal().string();
  if (session->suite().log) report.log = session->suite().log->lexically_normal().string();
  report.renderer = session->key().text();
  report.made_at = nowText();
  report.run_command = commandText("run", arguments);
  report.approve_command = commandText("approve", arguments) + " -m 'WHY'";
  const bool progress = ::isatty(STDERR_FILENO) == 1 && session->frames().size() > 8;
  for (const SuiteFrame& frame : session->frames()) {
    if (cli::stopRequested()) {
      return Error{ErrorKind::refused, "interrupted: nothing was judged", report.suite};
    }
    auto judged = session->judge(frame);
    if (!judged.ok()) return judged.error();
    if (!quiet) printFrame(*judged);
    report.session = judged->session;
    report.frames.push_back(std::move(*judged));
    if (progress) {
      fmt::print(stderr, "\r{}/{} ", report.frames.size(), session->frames().size());
    }
  }
  if (progress) fmt::print(stderr, "\r          \r");
  if (auto written = writeOutputs(report, arguments); !written) return written.error();
  if (!quiet) {
    fmt::print("{} frames: {} same, {} different, {} missing, {} unstable, {} incomparable\n",
               report.frames.size(), report.count(FrameVerdict::same),
               report.count(FrameVerdict::different), report.count(FrameVerdict::missing),
               report.count(FrameVerdict::unstable), report.count(FrameVerdict::incomparable));
    if (!arguments.report.empty()) fmt::print("report: {}/index.html\n", arguments.report);
  }
  return exitOf(report.verdict());
}

std::string userName() {
  for (const char* variable : {"ROCINANTE_USER", "USER", "LOGNAME"}) {
    if (const char* name = std::getenv(variable); name != nullptr && *name != '\0') return name;
  }
  return "uid " + std::to_string(::getuid());
}

Result<Exit> approveSuite(const Arguments& arguments) {
  auto session = SuiteSession::open(arguments.suite, suiteOptions(arguments));
  if (!session.ok()) return session.error();
  warnOfModelFaults(*session);
  std::size_t refused = 0;
  std::size_t approved = 0;
  for (const SuiteFrame& frame : session->frames()) {
    const Status status = session->approve(frame, userName(), nowText(), arguments.message);
    if (!status) {
      cli::warn(status.error().text());
      ++refused;
    } else {
      ++approved;
      fmt::print("approved {}\n", frame.name);
    }
    if (cli::stopRequested()) break;
  }
  if (approved > 0) {
    if (auto written = session->finishApproval(); !written) return written.error();
  }
  fmt::print("{} approved, {} refused; goldens in {}\n", approved, refused,
             session->suite().goldens.lexically_normal().string());
  return refused > 0 ? Exit::no : Exit::done;
}

void addSuiteOptions(CLI::App& app, Arguments& arguments) {
  app.add_option("SUITE", arguments.suite, "the suite's TOML file")->required();
  app.add_option("--cell", arguments.cell, "judge this cell in place of the suite's");
  app.add_option("--log", arguments.log, "judge this log in place of the suite's");
  app.add_option("--only", arguments.only, "glob over case names");
  app.add_option("--search", arguments.search, "root for model files; repeatable");
  app.add_flag("--search-env", arguments.search_environment,
               "search ROCINANTE_PATH, AMENT_PREFIX_PATH and ROS_PACKAGE_PATH too");
}

int goldenMain(int argc, char** argv) {
  CLI::App app("Visual regression: frames of a cell and a log against accepted pictures.",
               "rocinante-golden");
  Arguments arguments;
  app.require_subcommand(1);

  CLI::App* run = app.add_subcommand("run", "draw every case and judge it");
  addSuiteOptions(*run, arguments);
  run->add_option("--report", arguments.report, "folder for index.html and the pictures");
  run->add_option("--junit", arguments.junit, "write JUnit XML");
  run->add_option("--json", arguments.json_file, "write the verdicts as JSON; - is standard output")
      ->expected(0, 1)
      ->default_str("-");

  CLI::App* approve = app.add_subcommand("approve", "accept what is drawn now as goldens");
  addSuiteOptions(*approve, arguments);
  approve->add_option("-m,--message", arguments.message, "why; kept in the manifest")->required();

  CompareArguments compare_arguments;
  CLI::App* compare_command = addCompareCommand(app, compare_arguments);

  return cli::run(app, argc, argv, kExamples, [&]() -> Result<Exit> {
    cli::catchStopSignals();
    if (compare_command->parsed()) return runCompareCommand(compare_arguments);
    if (approve->parsed()) return approveSuite(arguments);
    return runSuite(arguments);
  });
}

}  // namespace
}  // namespace rocinante

int main(int argc, char** argv) {
  // Before any thread or context: what is judged must come out with the same bits everywhere.
  rocinante::pinRendererEnvironment();
  return rocinante::goldenMain(argc, argv);
}
