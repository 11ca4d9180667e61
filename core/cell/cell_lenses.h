#pragma once

#include "core/cell/cell.h"
#include "core/document/toml_table.h"

namespace rocinante {

/// Reads `intrinsics` and `distortion` of a [[camera]] (docs/cell-format.md, "Calibrated cameras").
/// Sets the field of view, too, for whatever knows no lens.
void readLens(TomlTable& table, CellCamera& camera);

}  // namespace rocinante
