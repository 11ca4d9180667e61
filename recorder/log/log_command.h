#pragma once

#include <functional>

#include "core/base/result.h"
#include "core/cli/program.h"

namespace CLI {
class App;
}

namespace rocinante {

/// A subcommand of `rocinante log`: its options, already added to the program, and what it does
/// once they are read. Each lies in a file of its own, NAME_command.h.
struct LogCommand {
  CLI::App* app = nullptr;
  std::function<Result<cli::Exit>()> run;
};

}  // namespace rocinante
