#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "viewer/ui/commands/command.h"
#include "viewer/ui/window/key_name.h"

namespace rocinante {

/// The command of a key and the words that it runs with.
struct KeyCommand {
  const Command* command = nullptr;
  const Shortcut* shortcut = nullptr;
};

/// The key's command; with Shift held, of the key alone if there is none with Shift. Empty when the
/// key means nothing.
std::optional<KeyCommand> commandOfKey(const KeyPress& press);

/// Runs the key's command, if it has one that makes sense now: a held key only repeats what
/// repeats, and without a log no command that needs one does anything.
Status runKey(const KeyPress& press, const CommandStage& stage);

/// The key as people read it: "Shift+H", "Space", "left".
std::string shownKey(std::string_view key);

/// What the command does with these words, and its keys for it, for people: "a second back (left)".
/// Empty for an unknown name.
std::string commandHint(std::string_view name, std::string_view words = {});

/// Keys of the command, for people: "left, right, Shift+left". Empty without one.
std::string shownKeys(const Command& command);

}  // namespace rocinante
