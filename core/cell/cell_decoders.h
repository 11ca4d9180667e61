#pragma once

#include "core/cell/cell.h"
#include "core/cell/cell_files.h"
#include "core/mesh/mesh_store.h"
#include "core/search/file_search.h"

namespace rocinante {

/// Reads `decoders` of one file of a cell: the file of decoders for what is not packet text
/// (docs/decoders.md). Only looks for it; whoever decodes reads it. Overrides what was read before.
void readDecodersName(const CellFile& file, const FileSearch& search, Cell& cell);

/// Adds the cell's file of decoders and the descriptors that it names to the files of the cell.
void addDecoderFiles(const Cell& cell, MeshStore& files);

}  // namespace rocinante
