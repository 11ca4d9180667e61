#pragma once

#include <string_view>

namespace CLI {
class App;
}  // namespace CLI

namespace rocinante::cli {

/// Sets the layout of --help for `app` and its subcommands: required arguments appear in the usage
/// line; an option shows the word for its value (or the values, `a|b|c`) and its default, but not
/// how it is checked. `examples` follow (for a subcommand those that show it), then the exit codes.
/// Call it once every option and subcommand exists.
void setHelp(CLI::App& app, std::string_view examples);

/// The type of a positional that the usage line shows as required, though CLI11 does not ask for
/// it. It is printed nowhere.
inline constexpr const char* kRequired = "REQUIRED";

}  // namespace rocinante::cli
