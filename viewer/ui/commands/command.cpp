#include "viewer/ui/commands/command.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "viewer/ui/commands/command_groups.h"

namespace rocinante {

std::vector<std::string> splitWords(std::string_view line) {
  constexpr std::string_view kBlanks = " \t\r";
  std::vector<std::string> words;
  while (true) {
    const std::size_t first = line.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) return words;
    line.remove_prefix(first);
    const std::size_t length = std::min(line.find_first_of(kBlanks), line.size());
    words.emplace_back(line.substr(0, length));
    line.remove_prefix(length);
  }
}

std::size_t Command::mostWords() const {
  constexpr std::size_t kAnyNumber = 1'000;
  return arguments.ends_with("...]") || arguments.ends_with("...") ? kAnyNumber
                                                                   : splitWords(arguments).size();
}

std::size_t Command::leastWords() const {
  const std::vector<std::string> words = splitWords(arguments);
  return static_cast<std::size_t>(
      std::ranges::count_if(words, [](const std::string& word) { return word[0] != '['; }));
}

const std::vector<Command>& allCommands() {
  static const std::vector<Command> kAll = [] {
    std::vector<Command> all;
    for (std::vector<Command> group :
         {timeCommands(), liveCommands(), plotCommands(), cameraCommands(), pictureCommands(),
          handCommands(), moveCommands(), inspectCommands(), backdropCommands(), publishCommands(),
          connectCommands(), programCommands(), scriptCommands(), inputCommands()}) {
      std::ranges::move(group, std::back_inserter(all));
    }
    return all;
  }();
  return kAll;
}

const Command* findCommand(std::string_view name) {
  const auto found = std::ranges::find(allCommands(), name, &Command::name);
  return found == allCommands().end() ? nullptr : &*found;
}

Result<const Command*> checkCommand(std::string_view name, std::size_t words) {
  const Command* const command = findCommand(name);
  if (command == nullptr) {
    return Error{ErrorKind::bad_argument, fmt::format("unknown command `{}`", name), {}};
  }
  const std::size_t least = command->leastWords();
  const std::size_t most = command->mostWords();
  if (words < least || words > most) {
    const std::string wanted =
        least == most ? fmt::format("{}", most) : fmt::format("{} to {}", least, most);
    return Error{
        ErrorKind::bad_argument,
        fmt::format("`{}` takes {} {}, not {}", name, wanted, most == 1 ? "word" : "words", words),
        {}};
  }
  return command;
}

Status runCommand(std::string_view name, CommandWords words, const CommandStage& stage) {
  const auto command = checkCommand(name, words.size());
  if (!command.ok()) return command.error();
  if ((*command)->needs_log && stage.model.cursor() == nullptr) {
    return Error{ErrorKind::bad_argument, fmt::format("`{}` needs a log", name), {}};
  }
  return (*command)->run(words, stage);
}

}  // namespace rocinante
