#include "golden/run/aligned_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace rocinante {
namespace {

void between(const TrackColumn& column, const double* a, const double* b, double part,
             double* out) {
  if (column.kind == TrackColumn::Kind::full_angle) {
    out[0] = a[0] + part * std::remainder(b[0] - a[0], 2 * std::numbers::pi);
    return;
  }
  const std::size_t linear = column.width() == 7 ? 3 : 1;
  for (std::size_t i = 0; i < linear; ++i) out[i] = a[i] + part * (b[i] - a[i]);
  if (linear == 1) return;
  double dot = 0;
  for (std::size_t i = 3; i < 7; ++i) dot += a[i] * b[i];
  const double sign = dot < 0 ? -1 : 1;
  double square = 0;
  for (std::size_t i = 3; i < 7; ++i) {
    out[i] = a[i] + part * (sign * b[i] - a[i]);
    square += out[i] * out[i];
  }
  if (!(square > 0)) return;
  for (std::size_t i = 3; i < 7; ++i) out[i] /= std::sqrt(square);
}

}  // namespace

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
    between(*column, a, device->row(before + 1) + column->offset, part, out);
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
