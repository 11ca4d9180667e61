#include "golden/run/aligned_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "golden/run/track_columns.h"

namespace rocinante {

AlignedGrid::AlignedGrid(const SessionTrack& first, const SessionTrack& other, const TimeMap& map) {
  times_.reserve(first.samples);
  places_.reserve(first.samples);
  const double last = static_cast<double>(other.samples) - 1;
  for (std::size_t i = 0; i < first.samples; ++i) {
    const LogTime time = map.inRun(first.start + first.step * static_cast<std::int64_t>(i));
    times_.push_back(time);
    const double place = secondsOf(time - other.start) / secondsOf(other.step);
    places_.push_back(std::clamp(place, 0.0, last));
  }
}

std::vector<double> AlignedGrid::values(const DeviceTrack* device,
                                        const TrackColumn* column) const {
  if (device == nullptr || column == nullptr) {
    return std::vector<double>(column == nullptr ? 7 : column->width(),
                               std::numeric_limits<double>::quiet_NaN());
  }
  const std::size_t width = column->width();
  if (device->rows.size() == device->width) {
    const double* const only = device->row(0) + column->offset;
    return {only, only + width};
  }
  std::vector<double> values(places_.size() * width);
  const std::size_t last = device->rows.size() / device->width - 1;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const auto before = std::min(static_cast<std::size_t>(places_[i]), last);
    const double part = places_[i] - static_cast<double>(before);
    const double* const a = device->row(before) + column->offset;
    double* const out = values.data() + i * width;
    if (part < 1e-9 || before == last) {
      std::copy(a, a + width, out);
      continue;
    }
    interpolate(*column, a, device->row(before + 1) + column->offset, part, out);
  }
  return values;
}

std::vector<double> AlignedGrid::updatesBefore(const DeviceTrack& device) const {
  std::vector<double> sums(device.updates.size() + 1);
  for (std::size_t i = 0; i < device.updates.size(); ++i) {
    sums[i + 1] = sums[i] + device.updates[i];
  }
  std::vector<double> before(places_.size());
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const auto sample = std::min(static_cast<std::size_t>(places_[i]), sums.size() - 1);
    const double part = places_[i] - static_cast<double>(sample);
    before[i] = sums[sample];
    if (sample + 1 < sums.size()) before[i] += part * (sums[sample + 1] - sums[sample]);
  }
  return before;
}

}  // namespace rocinante
