#include <vector>

#include "recorder/log/commands.h"

namespace {

constexpr const char* kExamples =
    "  rocinante log info session.mcap                 its contents, and whether it is whole\n"
    "  rocinante log info --json session.mcap          the same for scripts\n"
    "  rocinante log cat session.mcap --from 12.5s --until 14s\n"
    "  rocinante log cat session.mcap --channel '/udp/*/arm' --format json\n"
    "  rocinante log state session.mcap --at 12.5s     the state at that moment\n"
    "  rocinante log doctor session.mcap               check every rule of the format\n"
    "  rocinante log verify session.mcap --trust trusted.toml   who signed it\n"
    "  rocinante log diff before.mcap after.mcap       where they differ\n"
    "  rocinante log follow session.mcap               messages while they are recorded\n"
    "  rocinante log mark session.mcap 12.5s 'the gripper slipped'\n"
    "  rocinante log cut session.mcap -o pick.mcap --from-event pick --until-event place\n"
    "  rocinante log filter session.mcap -o arm.mcap --source arm\n"
    "  rocinante log merge left.mcap right.mcap -o both.mcap\n"
    "  rocinante log split session.mcap -o pieces/ --time 60s\n"
    "  rocinante log shift right.mcap -o right-on-time.mcap --by +0.25s\n"
    "  rocinante log recover killed.mcap -o whole.mcap\n"
    "  rocinante log decode raw.mcap --decoders robot.decoders.toml -o decoded.mcap\n"
    "  rocinante log attach session.mcap --cell demo.cell.toml -o carries_its_cell.mcap\n"
    "  rocinante log extract session.mcap --cell -o demo/\n"
    "  rocinante log table session.mcap -o session.csv   joints and poses as columns\n"
    "  rocinante log export demo.cell.toml session.mcap --foxglove -o foxglove.mcap\n"
    "  rocinante log import bag_0.mcap bag_1.mcap -o session.mcap --cell cell.toml\n";

}  // namespace

int main(int argc, char** argv) {
  using namespace rocinante;
  cli::Program app("Inspects logs, and makes new logs from logs. An existing log is never changed.",
                   "rocinante-log");
  app.requireSubcommand();
  const std::vector<cli::Subcommand> commands{
      addInfoCommand(app),    addCatCommand(app),    addStateCommand(app),   addDiffCommand(app),
      addDoctorCommand(app),  addFollowCommand(app), addMarkCommand(app),    addCutCommand(app),
      addFilterCommand(app),  addMergeCommand(app),  addSplitCommand(app),   addShiftCommand(app),
      addRecoverCommand(app), addAttachCommand(app), addExtractCommand(app), addVerifyCommand(app),
      addTableCommand(app),   addExportCommand(app), addImportCommand(app),  addDecodeCommand(app),
  };
  return cli::run(app, argc, argv, kExamples, [&] { return cli::runChosen(commands); });
}
