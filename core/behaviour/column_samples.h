#pragma once

#include <array>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "core/behaviour/session_track.h"
#include "core/behaviour/time_map.h"

namespace rocinante {

inline constexpr double kDegrees = 180 / std::numbers::pi;  ///< in a radian
inline constexpr double kMillimetres = 1000;                ///< in a metre

/// Components in which a value may differ from another of its column: degrees, or millimetres and
/// then degrees.
using Apart = std::array<double, 6>;

/// What leads from `reference` to `value`, two values of a column of this kind.
Apart apartOf(TrackColumn::Kind kind, const double* reference, const double* value);

/// The least and the most of several, each component by itself.
struct ApartRange {
  Apart least{}, most{};
  bool any = false;

  void add(const Apart& apart);
};

/// One column of one session: radians and metres, at times in nanoseconds since the start of the
/// first accepted session, on its time line. Angles that may turn for ever are not wound up. NaN:
/// nothing is stated from here on. The last value holds. Not for sharing between threads.
class ColumnSamples {
 public:
  ColumnSamples() = default;
  /// `times` of the series, which has the column, borrowed.
  ColumnSamples(const SessionTrack& track, const TrackSeries& series, const TrackColumn& column,
                const std::vector<std::int64_t>& times);

  std::size_t size() const { return times().size(); }
  std::int64_t time(std::size_t i) const { return times()[i]; }
  const double* value(std::size_t i) const { return values_.data() + i * width_; }
  bool isStated(std::size_t i) const { return value(i)[0] == value(i)[0]; }

  /// The last sample at or before a time; size() when there is none. Quick for a time near that of
  /// the last call.
  std::size_t at(std::int64_t time) const;
  /// What it has at a time, interpolated, with room for width() numbers. False: nothing is stated.
  bool valueAt(std::int64_t time, double* out) const;

  /// How `reference` differs from the values in [from, until], ends interpolated.
  ApartRange range(std::int64_t from, std::int64_t until, const double* reference) const;
  /// The same with what may lie between the packets (docs/decisions/041).
  ApartRange wideRange(std::int64_t from, std::int64_t until, const double* reference) const;
  /// What it has at a time is not interpolated.
  bool isHeld(std::int64_t time) const;
  /// True when packets were lost about a time: the interval there is longer than usual. Its ends.
  bool isLost(std::int64_t time, std::int64_t& from, std::int64_t& until) const;
  /// The farthest that a column of one number moves within a time, and when.
  double farthestWithin(std::int64_t reach, std::int64_t& when) const;
  /// Of a column of one number: the least and the most that is stated, without single values that
  /// are a hundred times as far away as all others; 0 where nothing is stated.
  std::pair<double, double> extremes() const;
  /// Of a column of one number: the standard deviation of what changes from packet to packet and
  /// goes on nowhere, by the median; 0 for a smooth or a stepped curve, and for few values.
  double noise() const;

 private:
  const std::vector<std::int64_t>& times() const {
    return shared_times_ != nullptr ? *shared_times_ : own_times_;
  }
  void load(const SessionTrack& track, const TrackSeries& series);
  void unwind();
  /// Values are interpolated from sample `i` to the next.
  bool isSmooth(std::size_t i) const;
  /// From sample `i` to the next, a second.
  Apart slope(std::size_t i) const;
  Apart apart(const double* reference, const double* value, double turns) const;
  /// Whole turns between the two.
  double turnsTo(const double* reference, const double* value) const;
  Apart corner(std::size_t i, bool& is_jump) const;
  /// corner() of a column of one number, computed once; negative: a jump.
  double cornerOf(std::size_t i) const;

  TrackColumn column_;
  std::size_t width_ = 1;
  const std::vector<std::int64_t>* shared_times_ = nullptr;
  std::vector<std::int64_t> own_times_;
  std::vector<double> values_;
  std::int64_t usual_ = 0;  ///< between packets
  mutable std::size_t last_ = 0;
  mutable std::vector<float> corners_;  ///< NaN: not computed yet
};

/// Times of a series on the time line of the first accepted session, since its `start`.
std::vector<std::int64_t> alignedTimes(const SessionTrack& track, const TrackSeries& series,
                                       const TimeMap& map, LogTime start);

}  // namespace rocinante
