#pragma once

#include <filesystem>
#include <string>

namespace rocinante {

/// The lines of `rocinante --version --parts`: one for each optional part, whether it was built,
/// with which libraries, or why not. A part is "absent" when it was built but its program (in
/// `programs`) or module is missing, for example because only some packages are installed.
std::string partsText(const std::filesystem::path& programs);

}  // namespace rocinante
