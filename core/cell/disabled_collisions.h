#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "core/cell/cell.h"

namespace rocinante {

/// The SRDF file beside a model's own, if there is one: of the same name, ending in `.srdf`.
using FindBeside =
    std::function<std::optional<std::filesystem::path>(const std::filesystem::path& srdf)>;

/// Adds to the exceptions of a clearance of one device with itself what SRDF files disable: of the
/// device's URDF file, and of `named` (empty: none), whose pairs hold for every device that has
/// both links. Files that were used are given to `used`; faults are the cell's.
void exceptDisabledCollisions(Cell& cell, CellClearance& clearance,
                              const std::filesystem::path& named, const FindBeside& beside,
                              const std::function<void(const std::filesystem::path&)>& used);

/// As FindBeside, of the file system alone.
std::optional<std::filesystem::path> srdfOnDisk(const std::filesystem::path& srdf);

}  // namespace rocinante
