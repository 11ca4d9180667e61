#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/packet/session_state.h"
#include "core/report/account.h"

namespace rocinante {

/// A motion of a device, sampled: a joint's value, or a pose of seven numbers (x y z, metres, then
/// the unit quaternion qx qy qz qw).
struct TrackColumn {
  enum class Kind : std::uint8_t {
    angle,       ///< radians
    full_angle,  ///< radians, of a joint that may turn for ever: modulo a turn
    length,      ///< metres
    pose,        ///< of the device in what carries it
    link_pose,   ///< in the world
  };
  std::string part;  ///< the joint's value or the link; empty: the device's own pose
  Kind kind = Kind::angle;
  std::size_t offset = 0;  ///< of its first number in a row

  std::size_t width() const { return kind >= Kind::pose ? 7 : 1; }
};

/// Samples of one device, row by row. NaN: nothing was stated yet, or the device is absent.
struct DeviceTrack {
  std::vector<TrackColumn> columns;
  std::size_t width = 0;     ///< numbers of a row
  std::vector<double> rows;  ///< one row when nothing ever changed
  /// Packets that stated something of the device, restated ones left out, by sample.
  std::vector<std::uint16_t> updates;

  const double* row(std::size_t sample) const {
    return rows.data() + (rows.size() == width ? 0 : sample * width);
  }
  const TrackColumn* find(std::string_view part, bool is_link) const;
};

/// What a session stated about something that does not move steadily: visibility, colour, presence,
/// carriers, drawings. Valid from `at` until the next one; an empty text means: nothing.
struct FactChange {
  LogTime at{};
  std::string text;
  /// Of drawings: extents, mean and 16 points, metres.
  std::vector<double> shape;
};

/// A session on a grid of times: everything that judging it as motion needs, from one pass over its
/// log. Does not depend on what it is compared with. A plain value.
struct SessionTrack {
  LogTime origin{}, start{}, end{};
  Nanoseconds step{0};
  std::size_t samples = 0;  ///< at start, start + step, ... up to `end`
  std::map<std::string, DeviceTrack, std::less<>> devices;
  std::map<std::string, std::vector<FactChange>, std::less<>> facts;
  std::vector<Event> events;  ///< without marks
  /// What packets stated and no device of the cell takes: other devices, values that do not fit.
  Account left_out;
};

/// The step for tracks that are judged together: 20 ms, or the least multiple of it with which all
/// of them fit in memory (400 MB). Logs that cannot be opened do not count.
Nanoseconds trackStep(const Cell& cell, const std::vector<std::filesystem::path>& logs);

/// Reads a log. Between two packets that are at most kInterpolated apart, values are interpolated;
/// otherwise the earlier one holds. damaged when a part of the log cannot be read: what is not seen
/// whole is not judged.
Result<SessionTrack> trackSession(const Cell& cell, const std::filesystem::path& log,
                                  Nanoseconds step);

inline constexpr Nanoseconds kInterpolated{std::chrono::milliseconds(250)};

}  // namespace rocinante
