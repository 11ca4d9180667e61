#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rocinante {

/// The folder for a package name, wherever the folder is and whatever its own name.
struct PackageFolder {
  std::string name;
  std::filesystem::path folder;
};

/// Where the user asked to look for files.
struct ModelSearch {
  std::vector<std::filesystem::path> search;  ///< roots in addition to the cell's
  bool search_environment = false;      ///< ROCINANTE_PATH, AMENT_PREFIX_PATH, ROS_PACKAGE_PATH too
  std::vector<PackageFolder> packages;  ///< take precedence over those of a cell
};

}  // namespace rocinante
