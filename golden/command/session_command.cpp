#include <fmt/format.h>

#include <iostream>
#include <tuple>

#include "core/cli/opened_session.h"
#include "core/cli/search_options.h"
#include "core/cli/status_line.h"
#include "core/cli/worker_threads.h"
#include "core/foreign/recordings/cell_and_log.h"
#include "golden/command/commands.h"
#include "golden/command/suite_arguments.h"
#include "golden/report/report_formats.h"
#include "golden/session/session_comparison.h"
#include "viewer/picture/picture_options.h"

namespace rocinante {
namespace {

Result<SessionQuestion> questionOf(const SessionArguments& arguments) {
  SessionQuestion question;
  question.a = arguments.a;
  question.b = arguments.b;
  question.more_accepted.assign(arguments.more_accepted.begin(), arguments.more_accepted.end());
  question.camera = arguments.camera;
  question.pictures = !arguments.no_pictures;
  const RunLimits& limits = arguments.limits;
  for (const auto& [option, limit, least] :
       {std::tuple("--joint-deg", limits.joint_deg, kRunFloors.joint_deg),
        std::tuple("--position-mm", limits.position_mm, kRunFloors.position_mm),
        std::tuple("--turn-deg", limits.turn_deg, kRunFloors.turn_deg),
        std::tuple("--event-ms", limits.event_ms, kRunFloors.event_ms)}) {
    if (limit >= least && limit <= 1e9) continue;
    return Error{ErrorKind::bad_argument,
                 fmt::format("{} must be at least {}: recordings of one motion differ by so much",
                             option, least),
                 ""};
  }
  if (!(limits.signal_share >= 0 && limits.signal_share <= 1e9)) {
    return Error{ErrorKind::bad_argument, "--signal-share must be at least 0", ""};
  }
  question.spec.limits = limits;
  question.spec.limits.link_positions = limits.position_mm != kRunFloors.position_mm;
  question.spec.limits.link_turns = limits.turn_deg != kRunFloors.turn_deg;
  question.spec.align = *runAlignNamed(arguments.align);
  const auto tolerance = Tolerance::named(arguments.tier);
  if (!tolerance.ok()) return tolerance.error();
  question.tolerance = *tolerance;
  const auto size = parsePictureSize(arguments.size);
  if (!size.ok()) return size.error();
  std::tie(question.picture.width, question.picture.height) = *size;
  return question;
}

}  // namespace

cli::CommandLine addSessionCommand(cli::CommandLine app, SessionArguments& arguments) {
  const cli::CommandLine command = app.addSubcommand(
      "session", "compare two recordings of one scenario, aligned by their events");
  command.addOption("A", arguments.a, "the accepted recording").required();
  command.addOption("B", arguments.b, "the new recording").required();
  command.addOption("CELL", arguments.cell, "the cell; default: the one that A carries");
  command
      .addOption("--accepted", arguments.more_accepted,
                 "one more accepted recording beside A; may be repeated: B is judged in the band "
                 "of all")
      .valueName("LOG")
      .oneEach();
  command.addOption("--align", arguments.align, "how times are matched: events, origin or warp")
      .oneOf({"events", "origin", "warp"})
      .showDefault();
  const auto addLimit = [&](const char* name, double& limit, const char* what) {
    command.addOption(name, limit, what).showDefault();
  };
  addLimit("--joint-deg", arguments.limits.joint_deg, "largest difference of a joint angle");
  addLimit("--position-mm", arguments.limits.position_mm, "largest difference of a position");
  addLimit("--turn-deg", arguments.limits.turn_deg, "largest difference of an orientation");
  addLimit("--signal-share", arguments.limits.signal_share,
           "largest difference of a signal's number, as a share of its accepted range");
  addLimit("--event-ms", arguments.limits.event_ms,
           "how much earlier or later an event or a value may come");
  command
      .addOption("--tier", arguments.tier, std::string("tolerance of the pictures: ") + kTierNames)
      .showDefault();
  command.addOption("--camera", arguments.camera, "a camera of the cell; default: its first");
  command.addOption("--size", arguments.size, "picture size").showDefault();
  command.addFlag("--no-pictures", arguments.no_pictures, "compare behaviour alone");
  command.addOption("--report", arguments.report, "folder for index.html and the pictures");
  cli::addSearchOptions(command, arguments);
  command.addFlag("--json", arguments.json, "print the answer as JSON");
  return command;
}

Result<cli::Exit> runSessionCommand(const SessionArguments& given) {
  SessionArguments arguments = given;
  // The cell may stand anywhere; A stays before B.
  orderCellAndLog(arguments.cell, arguments.b);
  if (orderCellAndLog(arguments.cell, arguments.a)) std::swap(arguments.a, arguments.b);
  const auto accepted = cli::openSession(arguments.a, arguments.cell, arguments);
  if (!accepted.ok()) return accepted.error();
  const bool is_alone = arguments.cell.empty();
  if (is_alone) arguments.cell = accepted->log;
  const auto fresh = cli::openSession(arguments.b, arguments.cell, arguments);
  if (!fresh.ok()) return fresh.error();
  std::vector<OpenedRecording> opened;  // holds temporary logs
  for (std::string& log : arguments.more_accepted) {
    auto more = cli::openSession(log, arguments.cell, arguments);
    if (!more.ok()) return more.error();
    log = more->log.string();
    opened.push_back(std::move(*more));
  }
  arguments.a = accepted->log;
  arguments.b = fresh->log;
  // The meshes of its own robot were looked for when it was imported.
  if (is_alone && accepted->imported) static_cast<ModelSearch&>(arguments) = {};
  const auto question = questionOf(arguments);
  if (!question.ok()) return question.error();
  CellOptions options;
  static_cast<ModelSearch&>(options) = arguments;
  options.parallel = cli::workerThreads();
  cli::StatusLine line;
  auto comparison = judgeSessions(arguments.cell, options, *question,
                                  [&line](const std::string& what) { line.show(what); });
  line.clear();
  if (!comparison.ok()) return fresh->named(accepted->named(comparison.error()));
  cli::warnOfAccount(arguments.a, nullptr);
  for (const std::string& log : arguments.more_accepted) cli::warnOfAccount(log, nullptr);
  cli::warnOfAccount(arguments.b, nullptr);
  if (accepted->imported || fresh->imported) {
    comparison->report.suite =
        accepted->recording.string() + " against " + fresh->recording.string();
  }
  std::cout << (arguments.json ? sessionJson(*comparison) : sessionText(*comparison));
  if (!arguments.report.empty()) {
    comparison->report.made_at = nowText();
    if (auto written = writeReport(comparison->report, arguments.report); !written) {
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
