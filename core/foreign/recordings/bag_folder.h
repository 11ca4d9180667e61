#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rocinante {

/// The files of a ROS 2 bag that is a folder with a metadata.yaml; empty for any other folder.
std::vector<std::filesystem::path> filesOfBagFolder(const std::filesystem::path& folder);

/// What the folder's metadata.yaml lists and filesOfBagFolder() has not, and what it states of the
/// messages that no reader expands: sentences. Empty for any other folder.
std::vector<std::string> damageOfBagFolder(const std::filesystem::path& folder);

}  // namespace rocinante
