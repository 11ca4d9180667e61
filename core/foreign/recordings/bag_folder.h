#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/foreign/ros/bag_reader.h"

namespace rocinante {

/// The files of a ROS 2 bag that is a folder with a metadata.yaml, by name: those that it lists, or
/// all where none of those is there; empty for any other folder.
std::vector<std::filesystem::path> filesOfBagFolder(const std::filesystem::path& folder);

/// What is read for a recording: its own path, or the files of a folder that is a ROS 2 bag.
std::vector<std::filesystem::path> filesOfRecording(const std::filesystem::path& recording);

/// Where the files of the folder and those of its metadata.yaml differ: sentences. Empty for any
/// other folder.
std::vector<std::string> damageOfBagFolder(const std::filesystem::path& folder);

/// What metadata.yaml says of the messages of filesOfBagFolder(), each and together. `first` is the
/// number of the first file among the inputs of an import.
std::vector<ros::StatedMessages> statedOfBagFolder(const std::filesystem::path& folder,
                                                   std::size_t first);

}  // namespace rocinante
