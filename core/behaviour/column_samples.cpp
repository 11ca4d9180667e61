#include "core/behaviour/column_samples.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <numbers>

#include "core/behaviour/session_track.h"

namespace rocinante {
namespace {

/// The rotation from `from` to `to` as a vector, degrees.
void turnBetween(const double* from, const double* to, double* into) {
  // conjugate(from) * to
  const double x = from[3] * to[0] - from[0] * to[3] - from[1] * to[2] + from[2] * to[1];
  const double y = from[3] * to[1] + from[0] * to[2] - from[1] * to[3] - from[2] * to[0];
  const double z = from[3] * to[2] - from[0] * to[1] + from[1] * to[0] - from[2] * to[3];
  const double w = from[3] * to[3] + from[0] * to[0] + from[1] * to[1] + from[2] * to[2];
  const double sine = std::sqrt(x * x + y * y + z * z);
  if (sine < 1e-15) {
    into[0] = into[1] = into[2] = 0;
    return;
  }
  const double sign = w < 0 ? -1 : 1;
  const double angle = 2 * std::atan2(sine, sign * w) * kDegrees;
  into[0] = sign * x / sine * angle;
  into[1] = sign * y / sine * angle;
  into[2] = sign * z / sine * angle;
}

constexpr double kTurn = 2 * std::numbers::pi;
/// An interval so much longer than usual has lost packets.
constexpr double kLost = 1.5;
/// Where the motion on both sides of an interval is so much slower, it is a jump.
constexpr double kJump = 0.25;
constexpr std::size_t kIntervalsLooked = 2'000;

/// `column` 0: the times.
template <class T>
void readBlock(const SessionTrack& track, const TrackSeries& series, std::size_t block,
               std::size_t column, std::size_t rows, T* out) {
  const ByteView bytes = track.samples->view();
  std::memcpy(out, bytes.data() + series.blocks[block] + column * rows * sizeof(T),
              rows * sizeof(T));
}

std::size_t rowsOf(const TrackSeries& series, std::size_t block) {
  return std::min<std::size_t>(kBlockRows, series.rows - block * kBlockRows);
}

}  // namespace

Apart apartOf(TrackColumn::Kind kind, const double* reference, const double* value) {
  Apart apart{};
  switch (kind) {
    case TrackColumn::Kind::angle:
      apart[0] = (value[0] - reference[0]) * kDegrees;
      break;
    case TrackColumn::Kind::full_angle:
      apart[0] = std::remainder(value[0] - reference[0], 2 * std::numbers::pi) * kDegrees;
      break;
    case TrackColumn::Kind::length:
      apart[0] = (value[0] - reference[0]) * kMillimetres;
      break;
    case TrackColumn::Kind::number:
      apart[0] = value[0] - reference[0];
      break;
    case TrackColumn::Kind::pose:
    case TrackColumn::Kind::link_pose:
      for (std::size_t i = 0; i < 3; ++i) apart[i] = (value[i] - reference[i]) * kMillimetres;
      turnBetween(reference + 3, value + 3, apart.data() + 3);
      break;
  }
  return apart;
}

void ApartRange::add(const Apart& apart) {
  if (!any) {
    least = most = apart;
    any = true;
    return;
  }
  for (std::size_t i = 0; i < apart.size(); ++i) {
    least[i] = std::min(least[i], apart[i]);
    most[i] = std::max(most[i], apart[i]);
  }
}

ColumnSamples::ColumnSamples(const SessionTrack& track, const TrackSeries& series,
                             const TrackColumn& column, const std::vector<std::int64_t>& times)
    : column_(column), width_(column.width()), shared_times_(&times) {
  load(track, series);
  const bool is_whole =
      std::none_of(values_.begin(), values_.end(), [](double value) { return std::isinf(value); });
  if (!is_whole) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
      if (std::isinf(value(i)[0])) continue;
      own_times_.push_back(times[i]);
      std::copy_n(value(i), width_, values_.data() + width_ * kept++);
    }
    values_.resize(kept * width_);
    shared_times_ = nullptr;
  }
  if (column_.kind == TrackColumn::Kind::full_angle) unwind();
  std::vector<std::int64_t> intervals;
  const std::size_t stride = size() / kIntervalsLooked + 1;
  for (std::size_t i = 0; i + 1 < size(); i += stride) intervals.push_back(time(i + 1) - time(i));
  if (intervals.empty()) return;
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
  std::ranges::nth_element(intervals, middle);
  usual_ = *middle;
}

void ColumnSamples::load(const SessionTrack& track, const TrackSeries& series) {
  values_.resize(series.rows * width_);
  std::vector<double> numbers(kBlockRows);
  for (std::size_t block = 0; block < series.blocks.size(); ++block) {
    const std::size_t rows = rowsOf(series, block);
    double* const out = values_.data() + block * kBlockRows * width_;
    for (std::size_t c = 0; c < width_; ++c) {
      const std::size_t number = 1 + column_.offset + c;
      if (width_ == 1) {
        readBlock(track, series, block, number, rows, out);
        continue;
      }
      readBlock(track, series, block, number, rows, numbers.data());
      for (std::size_t i = 0; i < rows; ++i) out[i * width_ + c] = numbers[i];
    }
  }
}

void ColumnSamples::unwind() {
  double turns = 0;
  double before = std::numeric_limits<double>::quiet_NaN();
  for (double& value : values_) {
    const double stated = value;
    if (!std::isnan(before) && !std::isnan(stated)) {
      turns -= std::round((stated - before) / kTurn) * kTurn;
    }
    if (!std::isnan(stated)) before = stated;
    value += turns;
  }
}

std::size_t ColumnSamples::at(std::int64_t time) const {
  const std::vector<std::int64_t>& all = times();
  if (all.empty() || time < all.front()) return all.size();
  std::size_t i = std::min(last_, all.size() - 1);
  constexpr std::size_t kNear = 16;
  for (std::size_t steps = 0; steps < kNear; ++steps) {
    if (all[i] > time) {
      --i;
    } else if (i + 1 < all.size() && all[i + 1] <= time) {
      ++i;
    } else {
      return last_ = i;
    }
  }
  return last_ = static_cast<std::size_t>(std::ranges::upper_bound(all, time) - all.begin()) - 1;
}

bool ColumnSamples::isSmooth(std::size_t i) const {
  return i + 1 < size() && time(i + 1) - time(i) <= kInterpolated.count() && isStated(i) &&
         isStated(i + 1);
}

bool ColumnSamples::valueAt(std::int64_t when, double* out) const {
  const std::size_t i = at(when);
  if (i == size() || !isStated(i)) return false;
  if (when == time(i) || !isSmooth(i)) {
    std::copy_n(value(i), width_, out);
    return true;
  }
  // Unwound angles need no shorter way.
  TrackColumn column = column_;
  if (column.kind == TrackColumn::Kind::full_angle) column.kind = TrackColumn::Kind::angle;
  const double part =
      static_cast<double>(when - time(i)) / static_cast<double>(time(i + 1) - time(i));
  interpolate(column, value(i), value(i + 1), part, out);
  return true;
}

double ColumnSamples::turnsTo(const double* reference, const double* value) const {
  if (column_.kind != TrackColumn::Kind::full_angle) return 0;
  return std::round((*value - *reference) / kTurn) * kTurn;
}

Apart ColumnSamples::apart(const double* reference, const double* value, double turns) const {
  if (column_.kind != TrackColumn::Kind::full_angle) {
    return apartOf(column_.kind, reference, value);
  }
  return {(*value - turns - *reference) * kDegrees};
}

ApartRange ColumnSamples::range(std::int64_t from, std::int64_t until,
                                const double* reference) const {
  ApartRange found;
  double ends[7];
  double turns = 0;
  const auto add = [&](const double* value) {
    if (!found.any) turns = turnsTo(reference, value);
    found.add(apart(reference, value, turns));
  };
  std::size_t i = at(from);
  if (i != size() && valueAt(from, ends)) add(ends);
  for (i = i == size() ? 0 : i + 1; i < size() && time(i) <= until; ++i) {
    if (isStated(i)) add(value(i));
  }
  if (valueAt(until, ends)) add(ends);
  return found;
}

Apart ColumnSamples::slope(std::size_t i) const {
  Apart found = apart(value(i), value(i + 1), 0);
  const double seconds = static_cast<double>(time(i + 1) - time(i)) * 1e-9;
  for (double& component : found) component = seconds > 0 ? component / seconds : 0;
  return found;
}

/// What the motion may be from a straight line between sample `i` and the next.
Apart ColumnSamples::corner(std::size_t i, bool& is_jump) const {
  const Apart here = slope(i);
  const Apart before = i > 0 && isSmooth(i - 1) ? slope(i - 1) : Apart{};
  const Apart after = isSmooth(i + 1) ? slope(i + 1) : Apart{};
  const double half = static_cast<double>(time(i + 1) - time(i)) * 1e-9 / 2;
  Apart most{};
  is_jump = true;
  for (std::size_t c = 0; c < most.size(); ++c) {
    most[c] = std::max(std::abs(here[c] - before[c]), std::abs(after[c] - here[c])) * half;
    const double beside = std::max(std::abs(before[c]), std::abs(after[c]));
    if (beside > kJump * std::abs(here[c])) is_jump = false;
  }
  return most;
}

double ColumnSamples::cornerOf(std::size_t i) const {
  if (corners_.empty()) corners_.assign(size(), std::numeric_limits<float>::quiet_NaN());
  float& known = corners_[i];
  if (std::isnan(known)) {
    bool is_jump = false;
    const Apart its = corner(i, is_jump);
    // Numbers of signals may be of any size; an infinite corner would accept everything.
    constexpr float kMost = std::numeric_limits<float>::max();
    known = is_jump ? -1 : its[0] < kMost ? static_cast<float>(its[0]) : kMost;
  }
  return known;
}

ApartRange ColumnSamples::wideRange(std::int64_t from, std::int64_t until,
                                    const double* reference) const {
  ApartRange found = range(from, until, reference);
  if (!found.any) return found;
  Apart wider{};
  std::size_t i = at(from);
  for (i = i == size() ? 0 : i; i + 1 < size() && time(i) <= until; ++i) {
    if (!isSmooth(i)) continue;
    bool is_jump = false;
    Apart corner{};
    if (width_ == 1) {
      corner[0] = cornerOf(i);
      is_jump = corner[0] < 0;
    } else {
      corner = this->corner(i, is_jump);
    }
    if (is_jump) {
      const double turns = turnsTo(reference, value(i));
      found.add(apart(reference, value(i), turns));
      found.add(apart(reference, value(i + 1), turns));
      continue;
    }
    for (std::size_t c = 0; c < wider.size(); ++c) wider[c] = std::max(wider[c], corner[c]);
  }
  for (std::size_t c = 0; c < wider.size(); ++c) {
    found.least[c] -= wider[c];
    found.most[c] += wider[c];
  }
  return found;
}

bool ColumnSamples::isHeld(std::int64_t when) const {
  const std::size_t i = at(when);
  return i != size() && !isSmooth(i);
}

bool ColumnSamples::isLost(std::int64_t when, std::int64_t& from, std::int64_t& until) const {
  const std::size_t i = at(when);
  if (i == size() || !isSmooth(i)) return false;
  from = time(i);
  until = time(i + 1);
  return static_cast<double>(until - from) > kLost * static_cast<double>(usual_);
}

double ColumnSamples::farthestWithin(std::int64_t reach, std::int64_t& when) const {
  double farthest = 0;
  std::size_t before = 0;
  for (std::size_t i = 0; i < size(); ++i) {
    while (time(i) - time(before) > reach) ++before;
    const double moved = std::abs(*value(i) - *value(before));
    if (!(moved > farthest)) continue;
    farthest = moved;
    when = time(i);
  }
  return farthest;
}

std::pair<double, double> ColumnSamples::extremes() const {
  constexpr double kFar = 100;
  constexpr std::size_t kOneIn = 100;
  std::vector<double> stated;
  for (std::size_t i = 0; i < size(); ++i) {
    if (isStated(i)) stated.push_back(*value(i));
  }
  if (stated.empty()) return {0, 0};
  const auto [least, most] = std::ranges::minmax(stated);
  const auto at = [&](std::size_t place) {
    const auto found = stated.begin() + static_cast<std::ptrdiff_t>(place);
    std::ranges::nth_element(stated, found);
    return *found;
  };
  const std::size_t outside = stated.size() / kOneIn;
  const double low = at(outside);
  const double high = at(stated.size() - 1 - outside);
  const bool is_far = high > low && (most - least) / kFar > high - low;
  return is_far ? std::pair(low, high) : std::pair(least, most);
}

double ColumnSamples::noise() const {
  // Of white noise the second difference has six times the variance, and its median lies at 0.6745
  // deviations.
  constexpr double kDeviations = 0.6745 * 2.449489742783178;
  constexpr std::size_t kFewest = 16;
  // What is sent when it changes comes at no rate, and its steps are no noise.
  const auto isUsual = [&](std::int64_t interval) {
    return 2 * interval > usual_ &&
           static_cast<double>(interval) < kLost * static_cast<double>(usual_);
  };
  std::vector<double> bends;
  const std::size_t stride = size() / kIntervalsLooked + 1;
  for (std::size_t i = 1; i + 1 < size(); i += stride) {
    if (!isUsual(time(i) - time(i - 1)) || !isUsual(time(i + 1) - time(i))) continue;
    const double bend = *value(i - 1) - 2 * *value(i) + *value(i + 1);
    if (std::isfinite(bend)) bends.push_back(std::abs(bend));
  }
  if (bends.size() < kFewest) return 0;
  const auto middle = bends.begin() + static_cast<std::ptrdiff_t>(bends.size() / 2);
  std::ranges::nth_element(bends, middle);
  return *middle / kDeviations;
}

std::vector<std::int64_t> alignedTimes(const SessionTrack& track, const TrackSeries& series,
                                       const TimeMap& map, LogTime start) {
  std::vector<std::int64_t> times(series.rows);
  for (std::size_t block = 0; block < series.blocks.size(); ++block) {
    readBlock(track, series, block, 0, rowsOf(series, block), times.data() + block * kBlockRows);
  }
  TimeMap::Walk walk(map);
  for (std::int64_t& time : times) {
    time = (walk.inAccepted(track.start + Nanoseconds(time)) - start).count();
  }
  return times;
}

}  // namespace rocinante
