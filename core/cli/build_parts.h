#pragma once

#include <cstddef>

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

}  // namespace rocinante
