#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

#include "core/base/time.h"

// The limits of packet text and of the state made from it: docs/packet-format.md, section "Limits".
// Anything beyond is left out and counted as too_many (or bad_name, bad_string, bad_header where
// the table says so).
namespace rocinante::limits {

inline constexpr std::size_t kNameBytes = 255;      ///< decoded
inline constexpr std::size_t kStringBytes = 4096;   ///< unescaped
inline constexpr std::size_t kJointValues = 4096;   ///< of one joints, order or joint statement
inline constexpr std::size_t kSignalValues = 4096;  ///< of one signals statement
inline constexpr std::size_t kUnitBytes = 32;       ///< of a signal's unit
inline constexpr std::uint32_t kRestatementParts = 65536;
inline constexpr std::uint32_t kDrawingParts = 4096;

inline constexpr std::size_t kSources = 4096;
inline constexpr std::size_t kRelays = 256;
inline constexpr std::size_t kDevices = 65536;
inline constexpr std::size_t kPaths = 262144;  ///< of visibility, and as many of colour
inline constexpr std::size_t kDrawings = 65536;
inline constexpr std::size_t kSignals = 65536;
inline constexpr std::size_t kViews = 4096;
inline constexpr std::size_t kEvents = 65536;  ///< waiting for takeEvents()
/// Limit of the whole state, as the table counts it: one sum for any mix of the items above.
inline constexpr std::uint64_t kStateBytes = std::uint64_t{256} << 20U;

/// A SEQUENCE further below the highest than this is a restart, not a late datagram.
inline constexpr std::uint64_t kReorderWindow = 64;
/// A restatement not completed within this log time from its first part is abandoned.
inline constexpr Nanoseconds kRestatementSpan = std::chrono::seconds(1);

inline constexpr double kDefaultLinePx = 1;
inline constexpr double kDefaultPointPx = 3;

}  // namespace rocinante::limits
