#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "core/cell/cell.h"

namespace rocinante {

/// A cell's text with the camera appended as a [[camera]]; existing bytes do not change.
/// bad_argument when the cell has a camera of that name, or its form admits no other table at the
/// end; damaged when it is not TOML. `file` names it in messages. Pure.
Result<std::string> withCamera(const std::string& cell, const CellCamera& camera,
                               const std::string& file);

/// The same in the file, which is only ever appended to: whoever writes it at the same time, and a
/// full disk, cannot cost a byte of it. bad_argument for anything but a *.toml.
Status appendCamera(const std::filesystem::path& file, const CellCamera& camera);

}  // namespace rocinante
