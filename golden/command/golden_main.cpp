// rocinante-golden: visual regression (docs/programs/golden.md).
#include <memory>
#include <vector>

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

using Commands = std::vector<cli::Subcommand>;

template <class Arguments>
cli::CommandLine add(cli::CommandLine app, Commands& commands,
                     cli::CommandLine (*declare)(cli::CommandLine, Arguments&),
                     Result<cli::Exit> (*run)(const Arguments&)) {
  const auto arguments = std::make_shared<Arguments>();
  commands.push_back({declare(app, *arguments), [arguments, run] { return run(*arguments); }});
  return commands.back().line;
}

int goldenMain(int argc, char** argv) {
  cli::Program app("Visual regression: frames of a cell and a log against accepted pictures.",
                   "rocinante-golden");
  app.requireSubcommand();
  Commands commands;
  addContextOption(add(app, commands, addRunCommand, runSuiteCommand));
  addContextOption(add(app, commands, addApproveCommand, runApproveCommand));
  add(app, commands, addListCommand, runListCommand);
  add(app, commands, addCaseCommand, runAddCommand);
  addContextOption(add(app, commands, addDiffCommand, runDiffCommand));
  add(app, commands, addReportCommand, runReportCommand);
  add(app, commands, addCompareCommand, runCompareCommand);
  addContextOption(add(app, commands, addBisectCommand, runBisectCommand));
  addContextOption(add(app, commands, addSessionCommand, runSessionCommand));
  add(app, commands, addSuggestCommand, runSuggestCommand);
  add(app, commands, addPushCommand, runPushCommand);
  add(app, commands, addGcCommand, runGcCommand);
  return cli::run(app, argc, argv, kExamples, [&] {
    cli::catchStopSignals();
    return cli::runChosen(commands);
  });
}

}  // namespace
}  // namespace rocinante

int main(int argc, char** argv) {
  // Before any thread or context, so that frames have the same bits everywhere.
  rocinante::pinRendererEnvironment();
  return rocinante::goldenMain(argc, argv);
}
