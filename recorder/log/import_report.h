#pragma once

#include <string>

#include "core/foreign/ros/bag_import.h"

namespace rocinante {

/// For the user: what was made, then one line a topic, with LF.
std::string importReportText(const std::string& output, const ros::ImportReport& report);
/// One JSON object for scripts, with LF (docs/programs/log.md).
std::string importReportJson(const std::string& output, const ros::ImportReport& report);

}  // namespace rocinante
