#pragma once

#include <cstddef>

namespace rocinante {

/// An optional part of this build, as CMake chose it (cmake/parts.cmake).
struct BuildPart {
  const char* name;
  const char* does;  ///< what it is for: "reading SDF"
  const char* file;  ///< the program or module (.so) it lies in; empty: inside the others
  bool built;
  const char* detail;  ///< built: its libraries with their versions; else why it was left out
};

extern const BuildPart kBuildParts[];
extern const std::size_t kBuildPartCount;

}  // namespace rocinante
