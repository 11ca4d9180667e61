#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace rocinante {

/// An optional part of this build, as CMake chose it (cmake/parts.cmake).
struct BuildPart {
  const char* name;
  const char* does;  ///< its purpose: "reading SDF"
  const char* file;  ///< the program or module (.so) that holds it; empty: built into the others
  bool built;
  const char* detail;  ///< built: its libraries with their versions; else why it was left out
};

extern const BuildPart kBuildParts[];
extern const std::size_t kBuildPartCount;

/// The lines of `rocinante --version --parts`: one for each optional part, whether it was built,
/// with which libraries, or why not. A part is "absent" when it was built but its program (in
/// `programs`) or module is missing, for example because only some packages are installed.
std::string partsText(const std::filesystem::path& programs);

}  // namespace rocinante
