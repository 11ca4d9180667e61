#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/behaviour/column_finding.h"
#include "core/behaviour/run_judgement.h"

namespace rocinante {
namespace {

class ShapeReader {
 public:
  explicit ShapeReader(const MotionShape& shape)
      : shape_(shape), first_(shape.first), last_(shape.last) {}

  /// Of as much on both sides, too.
  void widen() {
    const std::size_t margin = shape_.last - shape_.first + 1;
    first_ -= std::min(margin, first_);
    last_ = std::min(last_ + margin, shape_.run.size() - 1);
  }

  double run(double sample) const { return at(shape_.run, sample); }
  double accepted(double sample) const { return at(shape_.accepted, sample); }

  /// Root mean square of what `error` returns.
  template <class Error>
  double rms(Error error) const {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = first_; i <= last_; ++i) {
      const double value = error(static_cast<double>(i));
      if (std::isnan(value)) continue;
      sum += value * value;
      ++count;
    }
    return count == 0 ? 0 : std::sqrt(sum / static_cast<double>(count));
  }

 private:
  double at(const std::vector<double>& values, double sample) const {
    if (values.size() == 1) return values.front() * shape_.scale;
    const double last = static_cast<double>(values.size() - 1);
    const double place = std::clamp(sample, 0.0, last);
    const auto before = static_cast<std::size_t>(place);
    const std::size_t after = std::min(before + 1, values.size() - 1);
    const double part = place - static_cast<double>(before);
    return (values[before] + part * (values[after] - values[before])) * shape_.scale;
  }

  const MotionShape& shape_;
  std::size_t first_, last_;
};

constexpr double kMaxLate_s = 1;

std::string frozenText(const MotionShape& shape, const ShapeReader& reader) {
  const double held = reader.run(static_cast<double>((shape.first + shape.last) / 2));
  if (!std::isfinite(held)) return {};
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  std::size_t frozen = 0;
  for (std::size_t i = shape.first; i <= shape.last; ++i) {
    if (!(std::abs(reader.run(static_cast<double>(i)) - held) <= shape.limit / 5)) continue;
    ++frozen;
    least = std::min(least, reader.accepted(static_cast<double>(i)));
    most = std::max(most, reader.accepted(static_cast<double>(i)));
  }
  // It leaps when it is released, and the accepted one must have moved meanwhile.
  if (frozen * 10 < (shape.last - shape.first + 1) * 9 || most - least < 2 * shape.limit) return {};
  return fmt::format("frozen at {}{}", held < 0 ? "-" : "", figureText(std::abs(held), shape.unit));
}

std::string lateText(const MotionShape& shape, const ShapeReader& reader) {
  const double plain = reader.rms([&](double i) { return reader.run(i) - reader.accepted(i); });
  double best = plain;
  double best_lag = 0;
  const double half = 0.5;
  const double most = std::min(kMaxLate_s / shape.step_s, static_cast<double>(shape.last) / 2 + 2);
  for (double lag = -most; lag <= most; lag += half) {
    const double error =
        reader.rms([&](double i) { return reader.run(i) - reader.accepted(i - lag); });
    if (error >= best) continue;
    best = error;
    best_lag = lag;
  }
  if (best_lag == 0 || best > plain / 4) return {};
  return fmt::format("{} {}", figureText(std::abs(best_lag) * shape.step_s * 1e3, "ms"),
                     best_lag > 0 ? "late" : "early");
}

/// A step that comes late differs by as much all the while, as an offset does: but before and after
/// nothing does.
std::string lateStepText(const MotionShape& shape) {
  const std::size_t samples = shape.last - shape.first + 1;
  if (shape.first < samples || shape.last + samples >= shape.run.size() ||
      static_cast<double>(samples) * shape.step_s > kMaxLate_s) {
    return {};
  }
  ShapeReader wide(shape);
  wide.widen();
  return lateText(shape, wide);
}

double medianApart(const MotionShape& shape, const ShapeReader& reader) {
  std::vector<double> apart;
  for (std::size_t i = shape.first; i <= shape.last; ++i) {
    const double place = static_cast<double>(i);
    const double its = reader.run(place) - reader.accepted(place);
    if (!std::isnan(its)) apart.push_back(its);
  }
  if (apart.empty()) return 0;
  const auto middle = apart.begin() + static_cast<std::ptrdiff_t>(apart.size() / 2);
  std::ranges::nth_element(apart, middle);
  return *middle;
}

}  // namespace

std::string howItDiffers(const MotionShape& shape) {
  const ShapeReader reader(shape);
  if (shape.last < shape.first + 2) return "for an instant";
  if (std::string frozen = frozenText(shape, reader); !frozen.empty()) return frozen;
  const double plain = reader.rms([&](double i) { return reader.run(i) - reader.accepted(i); });
  const double mirrored = reader.rms([&](double i) { return reader.run(i) + reader.accepted(i); });
  if (mirrored < plain / 10) return "its sign is flipped";
  const double offset = medianApart(shape, reader);
  const double spread =
      reader.rms([&](double i) { return reader.run(i) - reader.accepted(i) - offset; });
  if (spread < std::abs(offset) / 5) {
    if (std::string late = lateStepText(shape); !late.empty()) return late;
    return fmt::format("offset by {}{}", offset < 0 ? "-" : "+",
                       figureText(std::abs(offset), shape.unit));
  }
  return lateText(shape, reader);
}

}  // namespace rocinante
