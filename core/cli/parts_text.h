#pragma once

#include <filesystem>
#include <string>

namespace rocinante {

/// What `rocinante --version --parts` lists: a line for each optional part, whether it was built,
/// with which libraries, and else why not. A part that was built and whose program (in `programs`)
/// or module is missing, as where only some packages are installed, is "absent".
std::string partsText(const std::filesystem::path& programs);

}  // namespace rocinante
