#pragma once

#include <filesystem>
#include <string>

namespace rocinante {

/// The path as somebody types it from the current folder.
std::string typedPath(const std::filesystem::path& path);

/// Whether the name ends as meshes, their materials and buffers, and pictures do. In either case.
bool isMeshOrTexture(const std::filesystem::path& path);

}  // namespace rocinante
