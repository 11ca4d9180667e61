#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/foreign/ros/bag_reader.h"

namespace rocinante {

/// True for a text whose first line is a JSON object with a time (timeUnitOf()).
bool looksLikeJsonLines(std::string_view text);
/// Why a text whose first line is a JSON object cannot be read; empty for any other text.
std::optional<std::string> jsonLinesRefusal(std::string_view text);

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
