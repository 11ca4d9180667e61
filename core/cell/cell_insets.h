#pragma once

#include "core/cell/cell.h"
#include "core/document/toml_table.h"

namespace rocinante {

/// Reads the `[[inset]]`s of one file of a cell into `cell`, after the cameras of all files were
/// read.
void readInsets(TomlTable& root, Cell& cell);

}  // namespace rocinante
