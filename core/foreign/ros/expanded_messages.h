#pragma once

#include <memory>

#include "core/foreign/ros/bag_reader.h"

namespace rocinante::ros {

/// The bag with those messages expanded that `ros2 bag record --compression-mode message` stored as
/// zstd frames. They are recognised one by one: a message with the encoding `cdr` begins with a
/// zero, a zstd frame does not. `file_bytes`: of the bag; bounds what all messages may claim
/// together (mcap::ExpansionBudget). What does not expand stays as it is stored, and is damage.
std::unique_ptr<BagReader> withExpandedMessages(std::unique_ptr<BagReader> bag,
                                                std::uint64_t file_bytes);

}  // namespace rocinante::ros
