#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/foreign/ros/bag_reader.h"

namespace rocinante {

/// What is read for a recording: its own path, or the files of a folder that is a ROS 2 bag.
std::vector<std::filesystem::path> filesOfRecording(const std::filesystem::path& recording);

/// Opens one of them, of any kind but captures: a folder is one of datagrams (datagram_folder.h), a
/// file is opened as by openRecording().
Result<std::unique_ptr<ros::BagReader>> openInput(const std::filesystem::path& path,
                                                  const std::string& device);

/// A session id that depends on the inputs alone.
Result<std::string> sessionIdOfInputs(const std::vector<std::filesystem::path>& paths);

}  // namespace rocinante
