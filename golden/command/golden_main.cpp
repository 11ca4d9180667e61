// rocinante-golden: visual regression (docs/programs/golden.md).
#include <CLI/CLI.hpp>
#include <functional>
#include <memory>

#include "core/cli/program.h"
#include "golden/command/commands.h"
#include "golden/command/compare_command.h"
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

using Chosen = std::function<Result<cli::Exit>()>;

/// Declares a subcommand; `chosen` does it once it was asked for.
template <class Arguments>
CLI::App& add(CLI::App& app, Chosen& chosen, CLI::App* (*declare)(CLI::App&, Arguments&),
              Result<cli::Exit> (*run)(const Arguments&)) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& command = *declare(app, *arguments);
  command.callback(
      [&chosen, arguments, run] { chosen = [arguments, run] { return run(*arguments); }; });
  return command;
}

int goldenMain(int argc, char** argv) {
  CLI::App app("Visual regression: frames of a cell and a log against accepted pictures.",
               "rocinante-golden");
  app.require_subcommand(1);
  Chosen chosen;
  addContextOption(add(app, chosen, addRunCommand, runSuiteCommand));
  addContextOption(add(app, chosen, addApproveCommand, runApproveCommand));
  add(app, chosen, addListCommand, runListCommand);
  add(app, chosen, addCaseCommand, runAddCommand);
  addContextOption(add(app, chosen, addDiffCommand, runDiffCommand));
  add(app, chosen, addReportCommand, runReportCommand);
  add(app, chosen, addCompareCommand, runCompareCommand);
  addContextOption(add(app, chosen, addBisectCommand, runBisectCommand));
  addContextOption(add(app, chosen, addSessionCommand, runSessionCommand));
  add(app, chosen, addSuggestCommand, runSuggestCommand);
  add(app, chosen, addPushCommand, runPushCommand);
  add(app, chosen, addGcCommand, runGcCommand);
  return cli::run(app, argc, argv, kExamples, [&] {
    cli::catchStopSignals();
    return chosen();
  });
}

}  // namespace
}  // namespace rocinante

int main(int argc, char** argv) {
  // Before any thread or context, so that frames have the same bits everywhere.
  rocinante::pinRendererEnvironment();
  return rocinante::goldenMain(argc, argv);
}
