#include "core/cell/cell_names.h"

#include <fmt/format.h>

namespace rocinante {

std::optional<std::string> CellNames::take(TomlTable& table) {
  const auto name = table.requiredName("name");
  return name ? take(table, *name) : std::nullopt;
}

std::optional<std::string> CellNames::take(TomlTable& table, const std::string& name) {
  static_cast<void>(table.node("name"));
  const std::string& file = table.faults().file();
  const Place place = table.place("name");
  const auto [known, is_new] = owners_.try_emplace({table.what(), name}, Owner{file, place});
  if (is_new) return name;
  const Owner& owner = known->second;
  const bool same_file = owner.file == file;
  if (!same_file && files_.includes(owner.file, file)) {
    table.faults().note(
        "cell.replaced", place,
        fmt::format("{} {} is replaced by that of {}:{}, which includes this file", table.what(),
                    quotedInFault(name), owner.file, owner.place.line));
    return std::nullopt;
  }
  table.error("cell.duplicate-name", "name",
              fmt::format("a second {} is named {}", table.what(), quotedInFault(name)),
              same_file ? "the first one is used"
                        : fmt::format("that of {}:{} is used", owner.file, owner.place.line));
  return std::nullopt;
}

}  // namespace rocinante
