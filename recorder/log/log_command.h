#pragma once

#include <functional>

#include "core/base/result.h"
#include "core/cli/program.h"

namespace CLI {
class App;
}

namespace rocinante {

/// A subcommand of `rocinante log`: its options, already added to the program, and the function to
/// run once they are parsed. Each has its own NAME_command.h.
struct LogCommand {
  CLI::App* app = nullptr;
  std::function<Result<cli::Exit>()> run;
};

}  // namespace rocinante
