#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/behaviour/sample_store.h"
#include "core/cell/cell.h"
#include "core/kinematics/model.h"
#include "core/packet/session_state.h"
#include "core/report/account.h"

namespace rocinante {

/// A motion of a device: a joint's value, or a pose of seven numbers (x y z, metres, then the unit
/// quaternion qx qy qz qw).
struct TrackColumn {
  enum class Kind : std::uint8_t {
    angle,       ///< radians
    full_angle,  ///< radians, of a joint that may turn for ever: modulo a turn
    length,      ///< metres
    number,      ///< of a signal, in its unit
    pose,        ///< of the device in what carries it
    link_pose,   ///< in the device's own space
  };
  std::string part;  ///< the joint's value or the link; empty: the device's own pose
  Kind kind = Kind::angle;
  std::size_t series = 0;  ///< into DeviceTrack::series
  std::size_t offset = 0;  ///< of its first number in a row
  bool is_stated = false;  ///< packets state a value of it somewhere; until then the model's holds
  std::string unit{};      ///< of a number, as the first packet that has one says it

  std::size_t width() const { return kind >= Kind::pose ? 7 : 1; }
};

/// What packets stated together: a row a packet, each a time (nanoseconds since the track's start)
/// and `width` numbers. NaN: nothing is stated from here on, the device is absent. kNotHere: this
/// packet does not state it.
struct TrackSeries {
  std::size_t width = 0;
  std::uint64_t rows = 0;
  std::vector<std::uint64_t> blocks;  ///< places in the track's samples, in bytes
};

struct DeviceTrack {
  std::vector<TrackColumn> columns;
  std::vector<TrackSeries> series;  ///< joint values, and the device's own pose
  /// Packets that stated something of the device, restated ones left out, in each kCountBin since
  /// the track's start.
  std::vector<std::uint32_t> updates;

  const TrackColumn* find(std::string_view part, bool is_link) const;
};

/// What a session stated about something that does not move steadily: visibility, colour, presence,
/// carriers, drawings, booleans, texts and units of signals. Valid from `at` until the next one; an
/// empty text means: nothing.
struct FactChange {
  LogTime at{};
  std::string text;
  /// Of drawings: extents, mean and 16 points, metres.
  std::vector<double> shape;
  bool is_restated = false;  ///< so it was stated before, perhaps before the session began
};

/// Everything that judging a session as motion needs, from one pass over its log
/// (docs/decisions/041). Does not depend on what it is compared with. A value; copies share the
/// samples.
struct SessionTrack {
  LogTime origin{}, start{}, end{};
  std::map<std::string, DeviceTrack, std::less<>> devices;
  /// Of signals, by "signal PATH NAME": one number a row, at least one.
  std::map<std::string, TrackSeries, std::less<>> numbers;
  /// How often packets state a signal, whatever it is, by the same name: a row for each kSaidBin of
  /// the track in which some do, restated ones left out. Two numbers: the statements, and the
  /// squares of the intervals before them, s².
  std::map<std::string, TrackSeries, std::less<>> rhythms;
  std::map<std::string, std::vector<FactChange>, std::less<>> facts;
  std::vector<Event> events;  ///< without marks
  /// Some packets were made of another program's recording: another version may make more of it.
  bool is_imported = false;
  /// What packets stated and no device of the cell takes: other devices, values that do not fit.
  Account left_out;
  std::shared_ptr<const SampleBytes> samples = std::make_shared<SampleBytes>();
};

/// Reads a log. `links`: "DEVICE/LINK", whose poses are kept too (linksToJudge()). damaged when a
/// part of the log cannot be read: what is not seen whole is not judged. refused soon after `stop`
/// is requested.
Result<SessionTrack> trackSession(const Cell& cell, const std::filesystem::path& log,
                                  const std::vector<std::string>& links = {},
                                  const std::stop_token& stop = {});

/// Between two packets that are farther apart, the earlier one holds.
inline constexpr Nanoseconds kInterpolated{std::chrono::milliseconds(250)};
inline constexpr Nanoseconds kCountBin{std::chrono::milliseconds(20)};
inline constexpr Nanoseconds kSaidBin{std::chrono::milliseconds(100)};

/// Columns for every value of the model's joints, and the device's own pose last.
std::vector<TrackColumn> columnsOf(const Model& model);

/// Writes into `out` the value between `a` and `b` of a column, `part` (0 to 1) of the way from
/// `a`: angles that may turn for ever and orientations by the shorter way.
void interpolate(const TrackColumn& column, const double* a, const double* b, double part,
                 double* out);

}  // namespace rocinante
