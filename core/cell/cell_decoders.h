#pragma once

#include "core/cell/cell.h"
#include "core/cell/cell_files.h"
#include "core/search/file_search.h"

namespace rocinante {

/// Reads `decoders` of one file of a cell: the file of decoders for what is not packet text
/// (docs/decoders.md). Only looks for it; whoever decodes reads it. Overrides what was read before.
void readDecodersName(const CellFile& file, const FileSearch& search, Cell& cell);

}  // namespace rocinante
