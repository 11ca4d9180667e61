#pragma once

#include <string_view>

namespace CLI {
class App;
}

namespace rocinante::cli {

/// Sets how `app` and its subcommands say --help: what must be given stands in the usage line, an
/// option shows the word for its value (or the values, `a|b|c`) and its default, and nothing of how
/// they are checked. Below it stand `examples`, of a subcommand those that show it, and the exit
/// codes. Once every option and subcommand is there.
void setHelp(CLI::App& app, std::string_view examples);

}  // namespace rocinante::cli
