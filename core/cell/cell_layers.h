#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "core/cell/cell.h"
#include "core/cell/cell_names.h"
#include "core/document/toml_table.h"

namespace rocinante {

/// Reads the layers of a cell's files, before their devices; then checks what they hold.
class LayerReader {
 public:
  LayerReader(Cell& cell, CellNames& names) : cell_(cell), names_(names) {}

  void read(TomlTable& root);
  /// After the devices and sources of all files were read: drops members that do not exist.
  void finish();

 private:
  struct Holding {
    TomlTable table;
    std::size_t layer = 0;            // into Cell::layers
    std::vector<const TomlNode*> at;  // by member
  };
  void readMembers(TomlTable& table, CellLayer& layer, std::vector<const TomlNode*>& at);
  bool isThere(const TomlTable& table, Place place, const LayerMember& member) const;

  Cell& cell_;
  CellNames& names_;
  std::vector<Holding> holdings_;
  std::size_t members_ = 0;  // of all layers
};

/// Layers need no [[layer]]; where a cell has some, any other name at the table's `key` is probably
/// a typo.
void checkLayer(const TomlTable& table, std::string_view key, const Cell& cell,
                const std::string& layer);
}  // namespace rocinante
