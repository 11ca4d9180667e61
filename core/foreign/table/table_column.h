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

/// Whether the column is that of a signal, `signal PATH NAME`.
bool isSignalColumn(std::string_view name);

/// Whether the column is of a link's pose, `DEVICE/LINK:x` or `DEVICE/LINK:x in PATH`.
bool isLinkColumn(std::string_view name);

/// Whether the column is of what is derived of others: `d/dt VALUE`, `mean SECONDS VALUE`,
/// `VALUE - VALUE`, as `log table --derive` names them.
bool isDerivedColumn(std::string_view name);

/// A column that names its device, or the ROS topic that it comes from. Borrowed from the name.
struct TableColumn {
  std::string_view device;               ///< empty: `topic` tells
  std::string_view joint;                ///< empty: a component of the pose
  std::optional<std::size_t> pose_part;  ///< into kPoseEndings
  std::string_view topic = {};
  /// Of a topic: ".velocity" or ".effort", which is a signal; empty: the position.
  std::string_view quantity = {};
};

/// The meaning of "DEVICE.JOINT" (the first point separates), of "DEVICE:x" and so on, and of
/// "/TOPIC/JOINT/position" (or "velocity", "effort"), as PlotJuggler names the joints of a
/// JointState; empty for a name without any of them, and for a signal's.
std::optional<TableColumn> tableColumn(std::string_view name);

/// The component of a pose that a column without a device is, where all seven are there: "tx" or
/// "x" and so on, as TUM names them; into kPoseEndings.
std::optional<std::size_t> plainPosePart(std::string_view name);

/// Why a column of this name is no value of anything; empty when it may be one.
std::string_view notAValue(std::string_view name);

/// Parses seconds as programs print them ("12.5", "1e-05", "0.30000000000000004"), to the nearest
/// nanosecond without going through a double; with `down` in units of 10^-down seconds. Empty for
/// invalid or too large numbers.
std::optional<Nanoseconds> tableSeconds(std::string_view text, int down = 0);

}  // namespace rocinante
