#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "core/cell/cell_files.h"
#include "core/document/toml_table.h"

namespace rocinante {

/// The names of a cell's tables, over all its files. A file overrides the files that it includes;
/// otherwise the first table of a name is used.
class CellNames {
 public:
  explicit CellNames(const CellFiles& files) : files_(files) {}

  /// The table's `name` (or the argument `name` instead of it); empty, with a fault, when another
  /// table already has it.
  std::optional<std::string> take(TomlTable& table);
  std::optional<std::string> take(TomlTable& table, const std::string& name);

 private:
  struct Owner {
    std::string file;
    Place place;
  };
  const CellFiles& files_;
  std::map<std::pair<std::string, std::string>, Owner> owners_;  // by kind of table, and name
};

}  // namespace rocinante
