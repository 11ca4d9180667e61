#pragma once

#include <string_view>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace rocinante::cli {

/// Sets the layout of --help for `app` and its subcommands: required arguments appear in the usage
/// line; an option shows the word for its value (or the values, `a|b|c`) and its default, but not
/// how it is checked. `examples` follow (for a subcommand those that show it), then the exit codes.
/// Call it once every option and subcommand exists.
void setHelp(CLI::App& app, std::string_view examples);

/// The usage line shows this positional as required, though CLI11 does not ask for it: the program
/// does, where an optional one stands before it and one word alone is meant for this.
void showRequired(CLI::Option& positional);

}  // namespace rocinante::cli
