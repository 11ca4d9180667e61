#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "core/base/time.h"

/// The words of a table of joint values and poses (docs/programs/source.md, "The table").
namespace rocinante {

/// What follows the device in the names of the seven columns of a pose.
inline constexpr std::array<std::string_view, 7> kPoseEndings = {":x",  ":y",  ":z", ":qx",
                                                                 ":qy", ":qz", ":qw"};

/// Begins a column of distances, which says nothing about a device; device names hold no slash.
inline constexpr std::string_view kClearanceColumn = "clearance/";

/// A column that names its device. Borrowed from the name.
struct TableColumn {
  std::string_view device;
  std::string_view joint;                ///< empty: a component of the pose
  std::optional<std::size_t> pose_part;  ///< into kPoseEndings
};

/// The meaning of "DEVICE.JOINT" (the first point separates) and of "DEVICE:x" and so on; empty for
/// a name without a device.
std::optional<TableColumn> tableColumn(std::string_view name);

/// Parses seconds as programs print them ("12.5", "1e-05", "0.30000000000000004"), to the nearest
/// nanosecond without going through a double. Empty for invalid or too large numbers.
std::optional<Nanoseconds> tableSeconds(std::string_view text);

}  // namespace rocinante
