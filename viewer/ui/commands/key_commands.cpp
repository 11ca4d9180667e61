#include "viewer/ui/commands/key_commands.h"

#include <array>
#include <map>
#include <tuple>
#include <utility>

namespace rocinante {
namespace {

using Chord = std::tuple<int, bool, bool>;  // key, Shift, Control

const std::map<Chord, KeyCommand>& keyTable() {
  static const std::map<Chord, KeyCommand> kTable = [] {
    std::map<Chord, KeyCommand> table;
    for (const Command& command : allCommands()) {
      for (const Shortcut& shortcut : command.shortcuts) {
        const auto press = parseKey(shortcut.key);
        if (press)
          table.emplace(Chord{press->key, press->shift, press->control},
                        KeyCommand{&command, &shortcut});
      }
    }
    return table;
  }();
  return kTable;
}

}  // namespace

std::optional<KeyCommand> commandOfKey(const KeyPress& press) {
  const auto& table = keyTable();
  auto found = table.find({press.key, press.shift, press.control});
  if (found == table.end() && press.shift) found = table.find({press.key, false, press.control});
  if (found == table.end()) return std::nullopt;
  return found->second;
}

Status runKey(const KeyPress& press, const CommandStage& stage) {
  const auto key = commandOfKey(press);
  if (!key || (press.repeated && !key->command->repeats)) return {};
  if (key->command->needs_log && stage.model.cursor() == nullptr) return {};
  return key->command->run(splitWords(key->shortcut->words), stage);
}

std::string shownKey(std::string_view key) {
  std::string shown;
  for (const auto& [prefix, text] :
       {std::pair<std::string_view, std::string_view>("ctrl+", "Ctrl+"), {"shift+", "Shift+"}}) {
    if (!key.starts_with(prefix)) continue;
    shown += text;
    key.remove_prefix(prefix.size());
  }
  using Names = std::pair<std::string_view, std::string_view>;
  constexpr std::array kShown{Names{",", "comma"},     Names{".", "full stop"},
                              Names{"space", "Space"}, Names{"home", "Home"},
                              Names{"end", "End"},     Names{"tab", "Tab"},
                              Names{"escape", "Esc"},  Names{"backspace", "Backspace"}};
  for (const auto& [name, text] : kShown) {
    if (key == name) key = text;
  }
  return shown + std::string(key);
}

std::string commandHint(std::string_view name, std::string_view words) {
  const Command* const command = findCommand(name);
  if (command == nullptr) return {};
  std::string means(command->means), keys;
  for (const Shortcut& shortcut : command->shortcuts) {
    if (shortcut.words != words) continue;
    if (!shortcut.means.empty()) means = shortcut.means;
    keys += (keys.empty() ? "" : ", ") + shownKey(shortcut.key);
  }
  return keys.empty() ? means : means + " (" + keys + ")";
}

std::string shownKeys(const Command& command) {
  if (!command.keys_shown.empty()) return std::string(command.keys_shown);
  std::string keys;
  for (const Shortcut& shortcut : command.shortcuts) {
    keys += (keys.empty() ? "" : ", ") + shownKey(shortcut.key);
  }
  return keys;
}

}  // namespace rocinante
