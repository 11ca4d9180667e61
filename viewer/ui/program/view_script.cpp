#include "viewer/ui/program/view_script.h"

#include <fmt/format.h>

#include <algorithm>

#include "viewer/ui/commands/command.h"

namespace rocinante {
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
    command.words = splitWords(line);
    if (command.words.empty()) continue;
    command.name = command.words.front();
    command.words.erase(command.words.begin());

    if (const auto known = checkCommand(command.name, command.words.size()); !known.ok()) {
      Error fault = known.error();
      fault.where = fmt::format("{}:{}", name, line_number);
      return fault;
    }
    commands.push_back(std::move(command));
  }
  return commands;
}

}  // namespace rocinante
