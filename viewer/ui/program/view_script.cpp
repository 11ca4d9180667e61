#include "viewer/ui/program/view_script.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace rocinante {
namespace {

struct KnownCommand {
  std::string_view name;
  std::size_t words;
};

constexpr std::array kCommands{
    KnownCommand{"play", 0},       KnownCommand{"pause", 0},   KnownCommand{"seek", 1},
    KnownCommand{"speed", 1},      KnownCommand{"loop", 1},    KnownCommand{"camera", 1},
    KnownCommand{"orbit", 2},      KnownCommand{"pan", 2},     KnownCommand{"zoom", 1},
    KnownCommand{"fit", 0},        KnownCommand{"hide", 1},    KnownCommand{"show", 1},
    KnownCommand{"panels", 1},     KnownCommand{"select", 1},  KnownCommand{"wait", 1},
    KnownCommand{"screenshot", 1}, KnownCommand{"frame", 1},   KnownCommand{"quit", 0},
    KnownCommand{"style", 2},      KnownCommand{"help", 1},    KnownCommand{"insets", 1},
    KnownCommand{"auto", 1},       KnownCommand{"key", 1},     KnownCommand{"click", 2},
    KnownCommand{"detail", 1},     KnownCommand{"evidence", 1}};

}  // namespace

Result<std::vector<ViewCommand>> parseViewScript(std::string_view text, std::string_view name) {
  std::vector<ViewCommand> commands;
  int line_number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    ++line_number;
    line = line.substr(0, line.find('#'));

    ViewCommand command;
    command.line = line_number;
    while (true) {
      const std::size_t first = line.find_first_not_of(" \t\r");
      if (first == std::string_view::npos) break;
      line.remove_prefix(first);
      const std::size_t length = std::min(line.find_first_of(" \t\r"), line.size());
      command.words.emplace_back(line.substr(0, length));
      line.remove_prefix(length);
    }
    if (command.words.empty()) continue;
    command.name = command.words.front();
    command.words.erase(command.words.begin());

    const auto place = fmt::format("{}:{}", name, line_number);
    const auto* known = std::ranges::find(kCommands, command.name, &KnownCommand::name);
    if (known == kCommands.end()) {
      return Error{ErrorKind::bad_argument, fmt::format("unknown command `{}`", command.name),
                   place};
    }
    if (command.words.size() != known->words) {
      return Error{ErrorKind::bad_argument,
                   fmt::format("`{}` takes {} words, not {}", command.name, known->words,
                               command.words.size()),
                   place};
    }
    commands.push_back(std::move(command));
  }
  return commands;
}

}  // namespace rocinante
