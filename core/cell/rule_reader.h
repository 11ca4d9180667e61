#pragma once

#include "core/cell/cell.h"
#include "core/cell/cell_rules.h"
#include "core/document/toml_table.h"

namespace rocinante {

/// Reads `[rules]` of one file of a cell into `cell`.
void readRules(TomlTable& root, Cell& cell);
/// The keys of SourceLimits of a `[[source]]`.
SourceLimits readSourceLimits(TomlTable& table);

}  // namespace rocinante
