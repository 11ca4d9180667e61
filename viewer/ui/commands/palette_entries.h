#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/ui/commands/command.h"

namespace rocinante {

/// One line of the command palette.
struct PaletteEntry {
  std::string means;
  std::string line;  ///< the command and its words, as in a script
  std::string key;   ///< for people; empty: none
  /// The words are missing: choosing it lets the user type them.
  bool incomplete = false;
};

/// How well `query` matches `text`, higher is better: its letters occur in this order, case is
/// ignored, and runs and beginnings of words count more. Empty: they do not. Pure.
std::optional<int> fuzzyScore(std::string_view query, std::string_view text);

/// Every command that makes sense now, with the values that its argument may have, in the order of
/// the table.
std::vector<PaletteEntry> paletteEntries(ViewModel& model);

/// The entries that match what is typed, best first, in the order of the table when equal; all for
/// an empty query. If what is typed is a whole command itself, it comes first. At most `most`.
std::vector<PaletteEntry> matchingEntries(std::string_view typed, std::vector<PaletteEntry> entries,
                                          std::size_t most);

}  // namespace rocinante
