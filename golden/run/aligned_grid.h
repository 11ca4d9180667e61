#pragma once

#include <vector>

#include "golden/run/session_track.h"
#include "golden/run/time_map.h"

namespace rocinante {

/// Times of the first accepted session at which everything is compared, and where those are in the
/// samples of another one. Before a session's start and after its end its first and last sample
/// hold.
class AlignedGrid {
 public:
  AlignedGrid(const SessionTrack& first, const SessionTrack& other, const TimeMap& map);

  std::size_t size() const { return places_.size(); }
  /// The time in the other session.
  LogTime time(std::size_t sample) const { return times_[sample]; }

  /// Values of a column of the other session at every time: width() numbers each, or once when
  /// nothing ever changes. NaN where nothing is stated; all NaN when `device` is null.
  std::vector<double> values(const DeviceTrack* device, const TrackColumn* column) const;
  /// Packets about a device in the samples before each time, summed up.
  std::vector<double> updatesBefore(const DeviceTrack& device) const;

 private:
  std::vector<LogTime> times_;
  std::vector<double> places_;  ///< in samples of the other one, within its range
};

}  // namespace rocinante
