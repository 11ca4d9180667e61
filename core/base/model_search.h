#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rocinante {

/// The folder that a package's name means, wherever it lies and whatever it is called.
struct PackageFolder {
  std::string name;
  std::filesystem::path folder;
};

/// Where whoever runs a program says that files are looked for.
struct ModelSearch {
  std::vector<std::filesystem::path> search;  ///< roots besides the cell's own
  bool search_environment = false;      ///< ROCINANTE_PATH, AMENT_PREFIX_PATH, ROS_PACKAGE_PATH too
  std::vector<PackageFolder> packages;  ///< they outrank those of a cell
};

}  // namespace rocinante
