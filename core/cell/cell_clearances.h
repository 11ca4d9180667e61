#pragma once

#include "core/cell/cell.h"
#include "core/cell/cell_names.h"
#include "core/document/toml_table.h"

namespace rocinante {

/// Reads the `[[clearance]]`s of one file of a cell into `cell`, after the devices and sources of
/// all files were read.
void readClearances(TomlTable& root, CellNames& names, Cell& cell);

}  // namespace rocinante
