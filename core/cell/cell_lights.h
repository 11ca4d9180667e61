#pragma once

#include "core/cell/cell.h"
#include "core/cell/cell_names.h"
#include "core/document/toml_table.h"

namespace rocinante {

/// Reads the `[[light]]`s of one file of a cell into `cell`, before [scene].
void readLights(TomlTable& root, CellNames& names, Cell& cell);
/// After all files were read: the key light is the first of them.
void finishLights(Cell& cell);

}  // namespace rocinante
