#include "viewer/ui/program/view_script.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/base/duration_text.h"
#include "viewer/ui/commands/command.h"

namespace rocinante {
namespace {

/// Longer than anybody works with a window.
constexpr Nanoseconds kLongestScript = std::chrono::hours(24);

/// The time of a `frame-at`, which is later than the one before.
Result<Nanoseconds> frameTime(const std::string& word, std::optional<Nanoseconds> last) {
  const auto at = parseDuration(word);
  if (!at.ok()) return at;
  const auto wrong = [&](const std::string& why) {
    return Error{ErrorKind::bad_argument, fmt::format("`{}` {}", word, why), {}};
  };
  if (*at < Nanoseconds(0) || *at > kLongestScript) return wrong("must be from 0s to 24h");
  if (last && *at <= *last) return wrong("must be later than the frame before it");
  return at;
}

}  // namespace

Result<std::vector<ViewCommand>> parseViewScript(std::string_view text, std::string_view name) {
  std::vector<ViewCommand> commands;
  int line_number = 0;
  std::optional<Nanoseconds> last;
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

    const auto here = [&](Error fault) {
      return Error{fault.kind, std::move(fault.what), fmt::format("{}:{}", name, line_number)};
    };
    if (const auto known = checkCommand(command.name, command.words.size()); !known.ok()) {
      return here(known.error());
    }
    if (command.name == "frame-at") {
      const auto at = frameTime(command.words.front(), last);
      if (!at.ok()) return here(at.error());
      command.at = last = *at;
    }
    commands.push_back(std::move(command));
  }
  return commands;
}

}  // namespace rocinante
