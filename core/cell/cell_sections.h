#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/cell/cell.h"
#include "core/cell/cell_files.h"
#include "core/cell/cell_models.h"
#include "core/cell/cell_names.h"
#include "core/document/toml_table.h"
#include "core/mesh/mesh_store.h"
#include "core/search/file_search.h"

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

/// Reads the `[[clearance]]`s of one file of a cell in `folder` into `cell`, after the devices and
/// sources of all files were read. `files` receives the SRDF files that were read.
void readClearances(TomlTable& root, const std::filesystem::path& folder, CellNames& names,
                    MeshStore& files, Cell& cell);

/// Reads the `[[signal]]`s of one file of a cell into `cell`, after the devices of all files were
/// read.
void readSignals(TomlTable& root, Cell& cell);

/// Reads `decoders` of one file of a cell: the file of decoders for what is not packet text
/// (docs/decoders.md). Only looks for it; whoever decodes reads it. Overrides what was read before.
void readDecodersName(const CellFile& file, const FileSearch& search, Cell& cell);

/// Adds the cell's file of decoders and the descriptors that it names to the files of the cell.
void addDecoderFiles(const Cell& cell, MeshStore& files);

/// Reads the `[[inset]]`s of one file of a cell into `cell`, after the cameras of all files were
/// read.
void readInsets(TomlTable& root, Cell& cell);

/// Reads the `[[light]]`s of one file of a cell into `cell`, before [scene].
void readLights(TomlTable& root, CellNames& names, Cell& cell);
/// After all files were read: the key light is the first of them.
void finishLights(Cell& cell);

/// Reads `intrinsics` and `distortion` of a [[camera]] (docs/cell-format.md, "Calibrated cameras").
/// Sets the field of view, too, for whatever knows no lens.
void readLens(TomlTable& table, CellCamera& camera);

}  // namespace rocinante
