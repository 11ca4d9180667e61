#include "core/cli/usage_fault.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/name_hint.h"

namespace rocinante::cli {
namespace {

/// The subcommand whose arguments were being read, or the program itself.
const CLI::App& innermost(const CLI::App& app) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  return chosen.empty() ? app : innermost(*chosen.back());
}

std::string commandOf(const CLI::App& app) {
  const CLI::App* const parent = app.get_parent();
  return parent == nullptr ? app.get_name() : commandOf(*parent) + " " + app.get_name();
}

std::vector<std::string> optionNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::vector<std::string> subcommandNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* subcommand : app.get_subcommands({})) {
    // An unnamed one is a group of options.
    if (!subcommand->get_name().empty()) names.push_back(subcommand->get_name());
  }
  return names;
}

/// "; did you mean `--duration`?", also for a prefix that only one name has; or empty.
std::string hint(std::string_view name, const std::vector<std::string>& known) {
  const std::string close = didYouMean(name, {known.begin(), known.end()});
  if (!close.empty()) return "; " + close;
  std::vector<std::string_view> longer;
  for (const std::string& each : known) {
    if (std::string_view(each).starts_with(name)) longer.push_back(each);
  }
  if (longer.size() != 1) return {};
  return "; did you mean `" + std::string(longer.front()) + "`?";
}

/// "; did you mean CELL, which is given without `--cell`?"; or empty.
std::string hintAtArgument(const std::string& name, const CLI::App& app) {
  std::string argument = name.substr(std::min(name.find_first_not_of('-'), name.size()));
  std::ranges::transform(argument, argument.begin(), [](unsigned char letter) {
    return static_cast<char>(std::toupper(letter));
  });
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_positional() || option->get_name(true) != argument) continue;
    return "; did you mean " + argument + ", which is given without `" + name + "`?";
  }
  return {};
}

std::string unexpected(const CLI::App& app, const std::string& argument) {
  const bool option = argument.size() > 1 && argument.starts_with('-');
  if (option) {
    const std::string name = argument.substr(0, argument.find('='));
    const std::string at_argument = hintAtArgument(name, app);
    return "there is no option " + name +
           (at_argument.empty() ? hint(name, optionNames(app)) : at_argument);
  }
  const std::vector<std::string> subcommands = subcommandNames(app);
  if (!subcommands.empty() && app.get_subcommands().empty()) {
    return "there is no subcommand `" + argument + "`" + hint(argument, subcommands);
  }
  return "unexpected argument `" + argument + "`";
}

/// "0.500000" as "0.5".
std::string plainNumber(std::string_view text) {
  if (text.find('.') != text.npos && text.find_first_of("eE") == text.npos) {
    text.remove_suffix(text.size() - 1 - text.find_last_not_of('0'));
    if (text.ends_with('.')) text.remove_suffix(1);
  }
  return std::string(text);
}

/// "Value 20 not in range 64 to 65507": CLI11 prints [64 - 65507] from version 2.4 on.
std::string oneRangeWording(std::string_view message) {
  constexpr std::string_view kRange = " not in range ";
  const std::size_t at = message.find(kRange);
  if (at == message.npos) return std::string(message);
  std::string_view range = message.substr(at + kRange.size());
  std::string_view between = " to ";
  if (range.starts_with('[') && range.ends_with(']')) {
    range = range.substr(1, range.size() - 2);
    between = " - ";
  }
  const std::size_t middle = range.find(between);
  if (middle == range.npos) return std::string(message);
  return std::string(message.substr(0, at + kRange.size())) + plainNumber(range.substr(0, middle)) +
         " to " + plainNumber(range.substr(middle + between.size()));
}

/// "--a is required but 2 were given": CLI11 before 2.4 writes "and" in place of "but".
std::string oneCountWording(std::string message) {
  constexpr std::string_view kBut = " is required but ";
  const std::size_t at = message.find(kBut);
  if (at != message.npos) message.replace(at, kBut.size(), " is required and ");
  return message;
}

}  // namespace

std::string usageFault(const CLI::App& app, const CLI::ParseError& fault) {
  const CLI::App& innermost_app = innermost(app);
  const std::string where = " (see " + commandOf(innermost_app) + " --help)";
  const auto kind = static_cast<CLI::ExitCodes>(fault.get_exit_code());
  std::vector<std::string> left = innermost_app.remaining();
  if (left.empty()) left = app.remaining(true);
  // A missing argument is often there under a misspelt name: then the name is the fault.
  const bool about_names =
      kind == CLI::ExitCodes::ExtrasError || kind == CLI::ExitCodes::RequiredError;
  if (about_names && !left.empty()) return unexpected(innermost_app, left.front()) + where;
  const bool lacks_subcommand = kind == CLI::ExitCodes::RequiredError &&
                                !subcommandNames(innermost_app).empty() &&
                                innermost_app.get_subcommands().empty();
  if (lacks_subcommand) return "which subcommand?" + where;
  const std::string words = oneCountWording(fault.what());
  const std::string_view message = words;
  constexpr std::string_view kMissing = ": 1 required ";
  if (const std::size_t at = message.find(kMissing);
      at != message.npos && message.ends_with(" missing")) {
    std::string_view value = message.substr(at + kMissing.size());
    value.remove_suffix(std::string_view(" missing").size());
    return std::string(message.substr(0, at)) + " needs its " + std::string(value) + where;
  }
  return oneRangeWording(message) + where;
}

}  // namespace rocinante::cli
