#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/foreign/ros/bag_reader.h"

namespace rocinante {

/// Opens a folder of raw datagrams, a file each (docs/other-formats.md, "Folders of datagrams").
/// Its topic is captured, not imported. Memory is about 100 bytes a file, of a million files at
/// most. not_found when there is no file; unsupported when there are more, or when they are
/// recordings.
Result<std::unique_ptr<ros::BagReader>> openDatagramFolder(const std::filesystem::path& folder);

/// A session id that depends on the folder's datagrams: their names, times and sizes.
Result<std::string> datagramFolderId(const std::filesystem::path& folder);

}  // namespace rocinante
