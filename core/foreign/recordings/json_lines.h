#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/foreign/ros/bag_reader.h"

namespace rocinante {

/// True for a text whose first line is a JSON object with a time: `t`, `time`, `t_ns` or `time_ns`.
bool looksLikeJsonLines(std::string_view text);

/// JSON objects, one a line (docs/other-formats.md, "Tables and JSON lines"), as messages with the
/// encoding `json`, and their packets. Numbers are named by the keys that lead to them, with
/// points:
/// {"t":1,"arm":{"j1":0.1}} is arm.j1. Arrays `name` and `position` are pairs; `device`, `joint`
/// and `value` are one. A line that is not an object is malformed; one without a time is damage.
Result<std::unique_ptr<ros::BagReader>> openJsonLines(const std::filesystem::path& path,
                                                      const std::string& device);
Result<std::unique_ptr<ros::BagReader>> openJsonBytes(ByteView bytes, std::string name,
                                                      const std::string& device);

}  // namespace rocinante
