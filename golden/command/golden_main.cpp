// rocinante-golden: visual regression (docs/programs/golden.md).
#include <CLI/CLI.hpp>

#include "core/cli/program.h"
#include "golden/command/add_command.h"
#include "golden/command/approve_command.h"
#include "golden/command/bisect_command.h"
#include "golden/command/compare_command.h"
#include "golden/command/diff_command.h"
#include "golden/command/list_command.h"
#include "golden/command/report_command.h"
#include "golden/command/run_command.h"
#include "golden/command/session_command.h"
#include "golden/command/store_command.h"
#include "golden/command/suggest_command.h"
#include "viewer/gl/context_option.h"
#include "viewer/gl/renderer_key.h"

namespace rocinante {
namespace {

constexpr char kExamples[] =
    "  rocinante golden run examples/demo/demo.suite.toml --report out/report\n"
    "  rocinante golden run suite.toml --log new.mcap --only 'pick*' --junit out/junit.xml\n"
    "  rocinante golden approve suite.toml --only picked -m 'the gripper got longer fingers'\n"
    "  rocinante golden bisect cell.toml session.mcap --other-cell new/cell.toml\n"
    "  rocinante golden session accepted.mcap new.mcap cell.toml --report out/report\n"
    "  rocinante golden approve suite.toml -i -m 'looked at each'\n"
    "  rocinante golden suggest suite.toml --run lift monday.mcap tuesday.mcap friday.mcap\n"
    "  rocinante golden list suite.toml --verify\n"
    "  rocinante golden add suite.toml --case pick --event picked --after 200ms --camera overview\n"
    "  rocinante golden diff main suite.toml --report out/changes\n"
    "  rocinante golden report shard-1 shard-2 shard-3 --report out/report --junit out/junit.xml\n"
    "  rocinante golden compare before.png after.png --tier cpu\n";

int goldenMain(int argc, char** argv) {
  CLI::App app("Visual regression: frames of a cell and a log against accepted pictures.",
               "rocinante-golden");
  app.require_subcommand(1);
  RunArguments run_arguments;
  CLI::App* run = addRunCommand(app, run_arguments);
  ApproveArguments approve_arguments;
  CLI::App* approve = addApproveCommand(app, approve_arguments);
  ListArguments list_arguments;
  CLI::App* list = addListCommand(app, list_arguments);
  AddArguments add_arguments;
  CLI::App* add = addCaseCommand(app, add_arguments);
  DiffArguments diff_arguments;
  CLI::App* diff = addDiffCommand(app, diff_arguments);
  ReportArguments report_arguments;
  CLI::App* report = addReportCommand(app, report_arguments);
  CompareArguments compare_arguments;
  CLI::App* compare = addCompareCommand(app, compare_arguments);
  BisectArguments bisect_arguments;
  CLI::App* bisect = addBisectCommand(app, bisect_arguments);
  SessionArguments session_arguments;
  CLI::App* session = addSessionCommand(app, session_arguments);

  SuggestArguments suggest_arguments;
  CLI::App* suggest = addSuggestCommand(app, suggest_arguments);
  PushArguments push_arguments;
  CLI::App* push = addPushCommand(app, push_arguments);
  GcArguments gc_arguments;
  CLI::App* gc = addGcCommand(app, gc_arguments);

  // Subcommands that draw.
  for (CLI::App* command : {run, approve, diff, bisect, session}) addContextOption(*command);

  return cli::run(app, argc, argv, kExamples, [&]() -> Result<cli::Exit> {
    cli::catchStopSignals();
    if (run->parsed()) return runSuiteCommand(run_arguments);
    if (approve->parsed()) return runApproveCommand(approve_arguments);
    if (list->parsed()) return runListCommand(list_arguments);
    if (add->parsed()) return runAddCommand(add_arguments);
    if (diff->parsed()) return runDiffCommand(diff_arguments);
    if (report->parsed()) return runReportCommand(report_arguments);
    if (compare->parsed()) return runCompareCommand(compare_arguments);
    if (bisect->parsed()) return runBisectCommand(bisect_arguments);
    if (push->parsed()) return runPushCommand(push_arguments);
    if (gc->parsed()) return runGcCommand(gc_arguments);
    if (suggest->parsed()) return runSuggestCommand(suggest_arguments);
    if (session->parsed()) return runSessionCommand(session_arguments);
    return cli::Exit::could_not_run;
  });
}

}  // namespace
}  // namespace rocinante

int main(int argc, char** argv) {
  // Before any thread or context, so that frames have the same bits everywhere.
  rocinante::pinRendererEnvironment();
  return rocinante::goldenMain(argc, argv);
}
