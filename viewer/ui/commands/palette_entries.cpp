#include "viewer/ui/commands/palette_entries.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <utility>

#include "viewer/ui/commands/key_commands.h"

namespace rocinante {
namespace {

/// A palette with more lines than this per command helps nobody; typing the name works for all.
constexpr std::size_t kMaxChoices = 2000;

char lowered(char letter) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
}

bool isWordLetter(char letter) { return std::isalnum(static_cast<unsigned char>(letter)) != 0; }

std::string shortcutOf(const Command& command, std::string_view words) {
  for (const Shortcut& shortcut : command.shortcuts) {
    if (shortcut.words == words) return shownKey(shortcut.key);
  }
  return {};
}

void addEntries(const Command& command, const ViewModel& model,
                std::vector<PaletteEntry>& entries) {
  const std::string name(command.name);
  const std::string means(command.means);
  if (command.leastWords() == 0) {
    const auto plain = std::ranges::find(command.shortcuts, std::string_view(), &Shortcut::words);
    const bool has_text = plain != command.shortcuts.end() && !plain->means.empty();
    entries.push_back(
        {has_text ? std::string(plain->means) : means, name, shortcutOf(command, "")});
  }
  for (const Shortcut& shortcut : command.shortcuts) {
    if (shortcut.words.empty() || shortcut.means.empty()) continue;
    entries.push_back({std::string(shortcut.means), name + " " + std::string(shortcut.words),
                       shownKey(shortcut.key)});
  }
  if (command.choices != nullptr) {
    std::vector<std::string> choices = command.choices(model);
    choices.resize(std::min(choices.size(), kMaxChoices));
    for (const std::string& choice : choices) {
      entries.push_back({means, name + " " + choice, shortcutOf(command, choice)});
    }
  }
  if (command.leastWords() > 0) {
    entries.push_back({means, name + " " + std::string(command.arguments), {}, true});
  }
}

}  // namespace

std::optional<int> fuzzyScore(std::string_view query, std::string_view text) {
  constexpr int kRun = 4;
  constexpr int kWordStart = 6;
  constexpr int kWhole = 10;
  int score = 0;
  std::size_t from = 0;
  std::size_t last = std::string_view::npos;
  for (const char wanted : query) {
    if (wanted == ' ') continue;
    // The next letter if it fits, else the next beginning of a word, else anywhere.
    const auto fits = [&](std::size_t at) { return lowered(text[at]) == lowered(wanted); };
    const auto starts = [&](std::size_t at) { return at == 0 || !isWordLetter(text[at - 1]); };
    std::size_t found = std::string_view::npos;
    if (last != std::string_view::npos && from < text.size() && fits(from)) {
      found = from;
    } else {
      for (std::size_t at = from; at < text.size(); ++at) {
        if (!fits(at)) continue;
        if (found == std::string_view::npos) found = at;
        if (starts(at)) {
          found = at;
          break;
        }
      }
    }
    if (found == std::string_view::npos) return std::nullopt;
    score += 1;
    if (starts(found)) score += kWordStart;
    if (last != std::string_view::npos && found == last + 1) score += kRun;
    last = found;
    from = found + 1;
  }
  return query.size() == text.size() ? score + kWhole : score;
}

std::vector<PaletteEntry> paletteEntries(ViewModel& model) {
  std::vector<PaletteEntry> entries;
  for (const Command& command : allCommands()) {
    if (command.group == CommandGroup::script) continue;
    if (command.needs_log && model.cursor() == nullptr) continue;
    if (command.offered != nullptr && !command.offered(model)) continue;
    addEntries(command, model, entries);
  }
  return entries;
}

std::vector<PaletteEntry> matchingEntries(std::string_view typed, std::vector<PaletteEntry> entries,
                                          std::size_t most) {
  std::vector<std::pair<int, PaletteEntry>> scored;
  for (PaletteEntry& entry : entries) {
    const auto by_line = fuzzyScore(typed, entry.line);
    const auto by_means = fuzzyScore(typed, entry.means);
    if (!by_line && !by_means) continue;
    // The name is what somebody types who knows it.
    const int score = std::max(by_line ? *by_line + 1 : 0, by_means.value_or(0));
    scored.emplace_back(score, std::move(entry));
  }
  if (!typed.empty()) {
    std::ranges::stable_sort(scored, std::greater<>(), &std::pair<int, PaletteEntry>::first);
  }
  std::vector<PaletteEntry> matching;
  const std::vector<std::string> words = splitWords(typed);
  if (!words.empty()) {
    const auto command = checkCommand(words.front(), words.size() - 1);
    if (command.ok() && (*command)->group != CommandGroup::script && words.size() > 1) {
      std::string line;
      for (const std::string& word : words) line += (line.empty() ? "" : " ") + word;
      matching.push_back({std::string((*command)->means), std::move(line), {}});
    }
  }
  for (auto& [score, entry] : scored) {
    if (matching.size() >= most) break;
    if (matching.empty() || matching.front().line != entry.line) {
      matching.push_back(std::move(entry));
    }
  }
  return matching;
}

}  // namespace rocinante
