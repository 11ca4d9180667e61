#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/foreign/ros/bag_reader.h"

namespace rocinante {

/// What a file holds, told by its first bytes, never by its name.
enum class RecordingKind : std::uint8_t {
  none,        ///< nothing that we can import
  log,         ///< one of ours: read as it is
  bag,         ///< of ROS 1 or ROS 2, also as a folder, or any other MCAP file
  lcm,         ///< an event log of LCM
  capture,     ///< pcap or pcapng
  table,       ///< CSV with a column `t` or `time`
  json_lines,  ///< a JSON object a line
};

RecordingKind recordingKindOf(const std::filesystem::path& path);
/// By the first 64 KiB, or all of a shorter file. An MCAP file is a bag here: whether it is a log
/// of ours its channels tell.
RecordingKind recordingKindOf(ByteView first_bytes);

/// Why text that has the form of a table or of JSON lines cannot be read as one, as a sentence with
/// what is missing; why a folder is no recording; empty for any other file.
std::optional<std::string> refusalOf(const std::filesystem::path& path);

/// Whether programs that read logs import it first: all kinds but `none` and `log`.
bool isForeign(RecordingKind kind);

/// Opens a recording of any kind but captures (capture_import.h). `device`: of a table's columns
/// that name none; empty: none. As ros::openBag() otherwise.
Result<std::unique_ptr<ros::BagReader>> openRecording(const std::filesystem::path& path,
                                                      const std::string& device);

}  // namespace rocinante
