#include <vector>

#include "viewer/model/commands.h"

namespace {

constexpr const char* kExamples =
    "  rocinante model info arm.urdf                     its contents\n"
    "  rocinante model info demo.cell.toml --json        its contents as JSON\n"
    "  rocinante model tree arm.urdf                     links and joints as a tree\n"
    "  rocinante model fk arm.urdf --joints \"0 0.5 0 -1.2 0 0\"\n"
    "  rocinante model fk arm.urdf --degrees --joint elbow=90 --json\n"
    "  rocinante model fk demo.cell.toml --log session.mcap --at 12.5s --device arm\n"
    "  rocinante model clearance arm.urdf --joint elbow=2.4   does it touch itself?\n"
    "  rocinante model convert arm.urdf -o arm.cell.toml kinematics over one OBJ\n"
    "  rocinante model convert demo.cell.toml -o demo.stl\n";

}  // namespace

int main(int argc, char** argv) {
  using namespace rocinante;
  cli::Program app("Inspects and converts models and cells.", "rocinante-model");
  app.requireSubcommand();
  const std::vector<cli::Subcommand> commands{addInfoCommand(app), addTreeCommand(app),
                                              addFkCommand(app), addClearanceCommand(app),
                                              addConvertCommand(app)};
  return cli::run(app, argc, argv, kExamples, [&] { return cli::runChosen(commands); });
}
