#pragma once

#include "core/cell/cell.h"
#include "core/cell/cell_names.h"
#include "core/document/toml_table.h"
#include "core/mesh/mesh_store.h"

namespace rocinante {

/// Reads the `[[clearance]]`s of one file of a cell in `folder` into `cell`, after the devices and
/// sources of all files were read. `files` receives the SRDF files that were read.
void readClearances(TomlTable& root, const std::filesystem::path& folder, CellNames& names,
                    MeshStore& files, Cell& cell);

}  // namespace rocinante
