#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/foreign/ros/bag_import.h"
#include "core/mcap/byte_sink.h"

namespace rocinante {

/// Makes a log of a capture file (pcap or pcapng), with the messages that `rocinante record
/// pcap://./FILE` would keep: every UDP datagram, on the channel of its flow, captured and not
/// imported. Closes the sink. Of `options` cell, bundle, log, keyframes and progress are used; the
/// report's topics are the flows. not_found when there is no datagram; unsupported when this build
/// reads no captures. Memory does not grow with the file.
Result<ros::ImportReport> importCapture(const std::filesystem::path& capture,
                                        std::unique_ptr<ByteSink> sink, std::string session_id,
                                        const ros::ImportOptions& options);

}  // namespace rocinante
