#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/bundle/cell_bundle.h"
#include "core/cell/cell.h"

namespace rocinante {

/// Writes the bundle's files below `folder`, which exists. Never follows or replaces anything that
/// is there.
Status layOut(const CellBundle& bundle, const std::filesystem::path& folder);

/// Loads a bundle by way of a private folder: names mean what its manifest says, and no other file
/// is opened. The cell keeps the folder until the last of it is gone. Faults and errors name files
/// as `shown_as` + their name. Of `options` its roots and lookups mean nothing here.
Result<Cell> loadBundle(const CellBundle& bundle, const std::string& shown_as,
                        const CellOptions& options);

}  // namespace rocinante
