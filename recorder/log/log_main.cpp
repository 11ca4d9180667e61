#include <CLI/CLI.hpp>
#include <vector>

#include "recorder/log/log_commands.h"

namespace {

constexpr const char* kExamples =
    "  rocinante log info session.mcap                 what is in it, and whether it is whole\n"
    "  rocinante log info --json session.mcap          the same for scripts\n"
    "  rocinante log cat session.mcap --from 12.5s --until 14s\n"
    "  rocinante log cat session.mcap --channel '/udp/*/arm' --format json\n";

}  // namespace

int main(int argc, char** argv) {
  using namespace rocinante;
  CLI::App app("Looks into logs.", "rocinante-log");
  app.require_subcommand(1);
  const std::vector<LogCommand> commands{
      addInfoCommand(app),
      addCatCommand(app),
  };
  return cli::run(app, argc, argv, kExamples, [&]() -> Result<cli::Exit> {
    for (const LogCommand& command : commands) {
      if (command.app->parsed()) return command.run();
    }
    return cli::Exit::could_not_run;
  });
}
