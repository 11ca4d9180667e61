#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/cell/cell.h"
#include "core/cell/cell_models.h"
#include "core/cell/cell_names.h"
#include "core/document/toml_table.h"

namespace rocinante {

/// Reads the devices of a cell's files, then checks what they name.
class DeviceReader {
 public:
  DeviceReader(Cell& cell, CellModels& models, CellNames& names)
      : cell_(cell), models_(models), names_(names) {}

  void read(TomlTable& root, const std::filesystem::path& folder);
  /// After all files were read: fills Cell::models.
  void finish();

 private:
  Cell& cell_;
  CellModels& models_;
  CellNames& names_;
  std::vector<std::pair<TomlTable, std::string>> carried_;  // tables that say `on`, and the device
};

/// "did you mean ...?" for a device that the cell does not have, while more faults are listed.
std::string deviceHint(const TomlTable& table, const Cell& cell, std::string_view name);

/// Reads the other sections of one file of a cell into `cell`, and checks what they name. Values of
/// [scene] override those read before.
void readCameras(TomlTable& root, CellNames& names, Cell& cell);
void readSources(TomlTable& root, CellNames& names, Cell& cell);
void readScene(TomlTable& root, Cell& cell);

}  // namespace rocinante
