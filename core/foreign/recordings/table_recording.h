#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/foreign/ros/bag_reader.h"

namespace rocinante {

/// True for a text whose first lines have the header of a table (table_header.h).
bool looksLikeTable(std::string_view text);

/// The rows of a CSV file (docs/other-formats.md, "Tables and JSON lines") as messages with the
/// encoding `csv`, and their packets. Wide: a column for each value, as `source --csv` reads it.
/// Long: columns `joint` (or `name`) and `value` (or `position`), and perhaps `device`.
/// bad_argument with a sentence when the header lacks something. A row that does not fit the header
/// is malformed; one without a time is damage.
Result<std::unique_ptr<ros::BagReader>> openTable(const std::filesystem::path& path,
                                                  const std::string& device);
Result<std::unique_ptr<ros::BagReader>> openTableBytes(ByteView bytes, std::string name,
                                                       const std::string& device);

}  // namespace rocinante
