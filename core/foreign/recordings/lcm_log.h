#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/foreign/ros/bag_reader.h"

namespace rocinante {

/// True for the first bytes of an event log of LCM (https://lcm-proj.github.io/lcm, "Log File
/// Format"): EDA1DA01 and an event that is possible.
bool looksLikeLcm(ByteView first_bytes);

/// Events as messages on the topic of their channel, with the encoding `lcm`, or `rk1` where a
/// channel's first event is packet text. Between damaged events the next EDA1DA01 is looked for,
/// and what was skipped is damage. Times of LCM are microseconds. Events are read in the order of
/// the file, which is that of time but for what several threads logged at once.
Result<std::unique_ptr<ros::BagReader>> openLcmLog(const std::filesystem::path& path);
Result<std::unique_ptr<ros::BagReader>> openLcmBytes(ByteView bytes, std::string name);

}  // namespace rocinante
