#pragma once

#include "core/model/cell.h"
#include "core/model/cell_names.h"
#include "core/model/toml_table.h"

namespace rocinante {

/// Reads the `[[light]]`s of one file of a cell into `cell`, before [scene].
void readLights(TomlTable& root, CellNames& names, Cell& cell);
/// When all files were read: the key light is the first that there is.
void finishLights(Cell& cell);

}  // namespace rocinante
