#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace rocinante {

/// A line of a list of files.
struct FileEntry {
  std::string name;  ///< of a folder with a slash behind it
  bool is_folder = false;
  bool operator==(const FileEntry&) const = default;
};

/// True for names of what the window can show: cells, models and logs.
bool canBeShown(std::string_view file_name);

/// The folders and the files that can be shown, folders first, each by name; hidden ones are left
/// out, and all beyond some thousands. not_found or refused with the system's reason.
Result<std::vector<FileEntry>> listFolder(const std::filesystem::path& folder);

}  // namespace rocinante
