#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/cell/cell.h"

namespace rocinante {

/// A cell's text with another pose of one of its devices: numbers are replaced in place, everything
/// else, comments and blanks too, keeps its bytes. A rotation stays in the words that it is in; a
/// pose that is missing is added. A micrometre and a millionth of a degree are kept. bad_argument
/// when the text does not have the device, or has it elsewhere than `before`, or its form admits no
/// edit in place; damaged when it is not TOML. `file` names it in messages. Pure.
Result<std::string> withDevicePose(const std::string& cell, std::string_view device,
                                   const Pose& before, const Pose& after, const std::string& file);

/// Whether the text has a [[device]] of that name; false for what is no TOML.
bool definesDevice(const std::string& cell, std::string_view device);

/// The file of a cell that defines the device: `main`, or the only one that it includes; `files`
/// are all that were read. bad_argument, as a sentence, when there is none or more than one.
Result<std::filesystem::path> fileOfDevice(const std::filesystem::path& main,
                                           std::span<const std::filesystem::path> files,
                                           std::string_view device);

/// Writes the pose into the file, whole or not at all; a link stays a link.
Status savePose(const std::filesystem::path& file, std::string_view device, const Pose& before,
                const Pose& after);

}  // namespace rocinante
