#include "golden/command/session_command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <tuple>

#include "core/base/duration_text.h"
#include "core/cli/search_options.h"
#include "golden/command/suite_arguments.h"
#include "golden/report/report_folder.h"
#include "golden/session/session_comparison_text.h"
#include "viewer/program/render_job.h"

namespace rocinante {
namespace {

Result<SessionQuestion> questionOf(const SessionArguments& arguments) {
  SessionQuestion question;
  question.a = arguments.a;
  question.b = arguments.b;
  question.camera = arguments.camera;
  question.pictures = !arguments.no_pictures;
  question.limits.radians = arguments.radians;
  question.limits.metres = arguments.metres;
  const auto slack = parseDuration(arguments.slack);
  if (!slack.ok()) return slack.error();
  const auto step = parseDuration(arguments.step);
  if (!step.ok()) return step.error();
  if (*slack < Nanoseconds(0) || *step <= Nanoseconds(0)) {
    return Error{ErrorKind::bad_argument, "--slack must be at least zero, --step greater than zero",
                 ""};
  }
  question.limits.slack = *slack;
  question.limits.step = *step;
  const auto tolerance = Tolerance::named(arguments.tier);
  if (!tolerance.ok()) return tolerance.error();
  question.tolerance = *tolerance;
  const auto size = parseSize(arguments.size);
  if (!size.ok()) return size.error();
  std::tie(question.width, question.height) = *size;
  return question;
}

}  // namespace

CLI::App* addSessionCommand(CLI::App& app, SessionArguments& arguments) {
  CLI::App* command = app.add_subcommand(
      "session", "compare two recordings of one scenario, aligned by their events");
  command->add_option("A", arguments.a, "the accepted recording")->required();
  command->add_option("B", arguments.b, "the new recording")->required();
  command->add_option("CELL", arguments.cell, "the cell; default: the one that A carries");
  command->add_option("--radians", arguments.radians, "largest difference of a joint angle")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option("--metres", arguments.metres, "largest difference of a position")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option("--slack", arguments.slack, "largest time shift of a value")
      ->capture_default_str();
  command->add_option("--step", arguments.step, "period at which states are compared")
      ->capture_default_str();
  command
      ->add_option("--tier", arguments.tier,
                   std::string("tolerance of the pictures: ") + kTierNames)
      ->capture_default_str();
  command->add_option("--camera", arguments.camera, "a camera of the cell; default: its first");
  command->add_option("--size", arguments.size, "picture size")->capture_default_str();
  command->add_flag("--no-pictures", arguments.no_pictures, "compare only events and states");
  command->add_option("--report", arguments.report, "folder for index.html and the pictures");
  cli::addSearchOptions(*command, arguments);
  command->add_flag("--json", arguments.json, "print the answer as JSON");
  return command;
}

Result<cli::Exit> runSessionCommand(const SessionArguments& arguments) {
  const auto question = questionOf(arguments);
  if (!question.ok()) return question.error();
  CellOptions options;
  static_cast<ModelSearch&>(options) = arguments;
  const bool shows_progress = ::isatty(STDERR_FILENO) == 1;
  const auto progress = [&](const std::string& what) {
    if (shows_progress) fmt::print(stderr, "\r\033[K{} ", what);
  };
  const std::filesystem::path cell =
      arguments.cell.empty() ? arguments.a : std::filesystem::path(arguments.cell);
  auto comparison = judgeSessions(cell, options, *question, progress);
  if (shows_progress) fmt::print(stderr, "\r\033[K");
  if (!comparison.ok()) return comparison.error();
  std::cout << (arguments.json ? sessionJson(*comparison) : sessionText(*comparison));
  if (!arguments.report.empty()) {
    comparison->pictures.made_at = nowText();
    if (auto written = writeReport(comparison->pictures, arguments.report); !written) {
      return written.error();
    }
    if (!arguments.json) fmt::print("report: {}/index.html\n", arguments.report);
  }
  switch (comparison->verdict()) {
    case Verdict::same:
      return cli::Exit::done;
    case Verdict::different:
      return cli::Exit::no;
    case Verdict::incomparable:
      break;
  }
  return cli::Exit::could_not_run;
}

}  // namespace rocinante
