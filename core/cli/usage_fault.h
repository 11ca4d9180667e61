#pragma once

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace rocinante::cli {

/// The fault of a command line as one sentence, with a hint where a name was nearly right: "there
/// is no option --durtion; did you mean `--duration`? (see rocinante-record --help)". `app` is the
/// program whose arguments caused `fault`.
std::string usageFault(const CLI::App& app, const CLI::ParseError& fault);

}  // namespace rocinante::cli
