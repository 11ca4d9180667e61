#pragma once

#include <string_view>

namespace CLI {
class App;
}

namespace rocinante::cli {

/// Sets the layout of --help for `app` and its subcommands: required arguments appear in the usage
/// line; an option shows the word for its value (or the values, `a|b|c`) and its default, but not
/// how it is checked. `examples` follow (for a subcommand those that show it), then the exit codes.
/// Call it once every option and subcommand exists.
void setHelp(CLI::App& app, std::string_view examples);

}  // namespace rocinante::cli
