#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/bundle/cell_bundle.h"
#include "core/cell/cell.h"

namespace rocinante {

/// Writes the bundle's files below `folder`, which exists. Never follows or replaces anything that
/// exists.
Status layOut(const CellBundle& bundle, const std::filesystem::path& folder);

/// Loads a bundle through a private folder: its manifest resolves all names, and no other file is
/// opened. The folder lives as long as the cell and its copies. Faults and errors name files as
/// `shown_as` + their name. The roots and lookups of `options` are ignored.
Result<Cell> loadBundle(const CellBundle& bundle, const std::string& shown_as,
                        const CellOptions& options);

}  // namespace rocinante
