#pragma once

#include <filesystem>
#include <fstream>
#include <string_view>

namespace rocinante::test {

/// Writes a file and the folders above it.
inline void writeFile(const std::filesystem::path& path, std::string_view text) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

}  // namespace rocinante::test
