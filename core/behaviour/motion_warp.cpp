#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/behaviour/column_samples.h"
#include "core/behaviour/motion_judge.h"

namespace rocinante {
namespace {

constexpr std::int64_t kMostMoments = 500'000;

/// A change of the bend costs as much as one joint being this share of its range away for a sample:
/// equal stretches, where nothing moves, do not bend.
constexpr float kBendCost = 0.02F;
/// A joint that is farther away than this share of its range counts no more: one that does
/// something else must not bend all others.
constexpr double kFarShare = 0.1;
/// Joints that move less are noise, radians or metres.
constexpr double kLeastRange = 0.005;

/// Values of every joint that moves, sample by sample.
struct WarpFeatures {
  std::size_t count = 0;            ///< joints
  std::vector<float> first, other;  ///< `other` has more by the warp's reach, on either side
};

/// The times of the first session, and the values of columns at them.
class WarpGrid {
 public:
  explicit WarpGrid(const SessionTrack& first) : start_(first.start) {
    const Nanoseconds length = first.end - first.start;
    step_ = kWarpStep * (length / (kWarpStep * kMostMoments) + 1);
    samples_ = static_cast<std::size_t>(length / step_) + 1;
  }

  std::size_t samples() const { return samples_; }
  Nanoseconds step() const { return step_; }
  LogTime time(std::ptrdiff_t sample) const { return start_ + step_ * sample; }
  /// `more`: samples before the first and behind the last, too.
  std::vector<double> values(const SessionTrack& track, const DeviceTrack& device,
                             const TrackColumn& column, const TimeMap& map,
                             std::size_t more) const {
    const TrackSeries& series = device.series[column.series];
    const auto times = alignedTimes(track, series, map, start_);
    const ColumnSamples samples(track, series, column, times);
    std::vector<double> values(samples_ + 2 * more, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto sample = static_cast<std::ptrdiff_t>(i) - static_cast<std::ptrdiff_t>(more);
      static_cast<void>(samples.valueAt((time(sample) - start_).count(), &values[i]));
    }
    return values;
  }

 private:
  LogTime start_;
  Nanoseconds step_{0};
  std::size_t samples_ = 0;
};

WarpFeatures featuresOf(const SessionTrack& first, const SessionTrack& other, const TimeMap& map,
                        const WarpGrid& grid, std::size_t reach) {
  const TimeMap identity{{{first.start, first.start}}};
  std::vector<std::vector<double>> a, b;
  for (const auto& [name, device] : first.devices) {
    const auto its = other.devices.find(name);
    if (its == other.devices.end()) continue;
    for (const TrackColumn& column : device.columns) {
      if (column.width() != 1) continue;
      const TrackColumn* same = its->second.find(column.part, false);
      if (same == nullptr || same->kind != column.kind) continue;
      std::vector<double> values = grid.values(first, device, column, identity, 0);
      double least = std::numeric_limits<double>::infinity();
      double most = -least;
      for (const double value : values) {
        if (std::isnan(value)) continue;
        least = std::min(least, value);
        most = std::max(most, value);
      }
      if (!(most - least > kLeastRange)) continue;
      std::vector<double> others = grid.values(other, its->second, *same, map, reach);
      for (std::vector<double>* list : {&values, &others}) {
        for (double& value : *list) value /= (most - least) * kFarShare;
      }
      a.push_back(std::move(values));
      b.push_back(std::move(others));
    }
  }
  WarpFeatures features;
  features.count = a.size();
  const auto list = [](const std::vector<std::vector<double>>& columns, std::size_t samples,
                       std::vector<float>& into) {
    for (std::size_t i = 0; i < samples; ++i) {
      for (const auto& column : columns) into.push_back(static_cast<float>(column[i]));
    }
  };
  list(a, grid.samples(), features.first);
  list(b, grid.samples() + 2 * reach, features.other);
  return features;
}

class Warper {
 public:
  Warper(const WarpFeatures& features, std::size_t samples, std::size_t reach)
      : features_(features), samples_(samples), reach_(reach), width_(2 * reach + 1) {
    for (std::size_t i = 0; i < samples; ++i) {
      const auto row =
          features.other.begin() + static_cast<std::ptrdiff_t>((i + reach) * features.count);
      is_known_.push_back(!std::all_of(row, row + static_cast<std::ptrdiff_t>(features.count),
                                       [](float value) { return std::isnan(value); }));
    }
  }

  /// By sample: how many samples later the other session is. `fixed`: where that is 0.
  std::vector<std::ptrdiff_t> bends(const std::vector<bool>& fixed) {
    came_.assign(samples_ * width_, 0);
    std::vector<float> before(width_), now(width_);
    for (std::size_t i = 0; i < samples_; ++i) {
      for (std::size_t k = 0; k < width_; ++k) now[k] = costOf(i, k, fixed[i], before);
      std::swap(before, now);
    }
    std::vector<std::ptrdiff_t> bends(samples_);
    auto k = static_cast<std::size_t>(std::ranges::min_element(before) - before.begin());
    for (std::size_t i = samples_; i-- > 0;) {
      bends[i] = static_cast<std::ptrdiff_t>(k) - static_cast<std::ptrdiff_t>(reach_);
      k = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(k) + came_[i * width_ + k]);
    }
    return bends;
  }

 private:
  float costOf(std::size_t i, std::size_t k, bool is_fixed, const std::vector<float>& before) {
    constexpr float kNever = std::numeric_limits<float>::infinity();
    if (is_fixed && k != reach_) return kNever;
    const float apart = apartAt(i, k);
    if (i == 0) return apart;
    float least = before[k];
    std::int8_t from = 0;
    if (k > 0 && before[k - 1] + kBendCost < least) {
      least = before[k - 1] + kBendCost;
      from = -1;
    }
    if (k + 1 < width_ && before[k + 1] + kBendCost < least) {
      least = before[k + 1] + kBendCost;
      from = 1;
    }
    came_[i * width_ + k] = from;
    return least + apart;
  }

  float apartAt(std::size_t i, std::size_t k) const {
    // Outside the other session nothing fits better than anything else.
    if (!is_known_[i]) return 0;
    const float* a = features_.first.data() + i * features_.count;
    const float* b = features_.other.data() + (i + k) * features_.count;
    float sum = 0;
    for (std::size_t c = 0; c < features_.count; ++c) {
      const float apart = std::abs(a[c] - b[c]);
      sum += apart < 1 ? apart : 1;  // NaN counts as far away
    }
    return sum;
  }

  const WarpFeatures& features_;
  std::size_t samples_, reach_, width_;
  std::vector<bool> is_known_;     ///< by sample: the other session has values there
  std::vector<std::int8_t> came_;  ///< by sample and bend: the bend before it, relative to it
};

}  // namespace

TimeMap warpedMap(const SessionTrack& first, const SessionTrack& other, const TimeMap& map,
                  bool keeps_knots, Nanoseconds most) {
  const WarpGrid grid(first);
  const auto reach = static_cast<std::size_t>(most / grid.step());
  const WarpFeatures features = featuresOf(first, other, map, grid, reach);
  if (features.count == 0 || reach == 0 || grid.samples() < 3) return map;
  std::vector<bool> fixed(grid.samples());
  if (keeps_knots) {
    for (const TimeMap::Knot& knot : map.knots) {
      const auto sample = (knot.accepted - first.start + grid.step() / 2) / grid.step();
      if (sample >= 0 && sample < static_cast<std::int64_t>(grid.samples())) {
        fixed[static_cast<std::size_t>(sample)] = true;
      }
    }
  } else {
    fixed.front() = true;
  }
  const std::vector<std::ptrdiff_t> bends = Warper(features, grid.samples(), reach).bends(fixed);
  TimeMap warped;
  warped.rate = map.rate;
  for (std::size_t i = 0; i < bends.size(); ++i) {
    const bool is_corner = i == 0 || i + 1 == bends.size() || bends[i] != bends[i - 1] ||
                           bends[i] != bends[i + 1] || fixed[i];
    if (!is_corner) continue;
    const auto sample = static_cast<std::ptrdiff_t>(i);
    const LogTime time = grid.time(sample);
    // Behind the end of the first session, too: what is late there comes after it.
    LogTime in_other = map.inRun(grid.time(sample + bends[i]));
    if (!warped.knots.empty()) in_other = std::max(in_other, warped.knots.back().run);
    warped.knots.push_back({time, in_other});
  }
  return warped;
}

}  // namespace rocinante
