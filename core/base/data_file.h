#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"

namespace rocinante {

/// A file that is installed with the programs, by its name below share/rocinante
/// ("examples/demo/motion.mcap"). A program in a build folder finds that of the source tree.
/// not_found with the folders that were searched.
Result<std::filesystem::path> findDataFile(const std::string& name);

}  // namespace rocinante
