#include "recorder/contents/activity.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace rocinante {
namespace {

/// Two messages this many parts apart or more are not a stream: a whole part lies between them.
constexpr double kSilentParts = 2;

std::size_t partAt(double place) {
  return std::min(static_cast<std::size_t>(place), kActivityParts - 1);
}

}  // namespace

Activity::Activity(LogTime start, LogTime end)
    : start_(start),
      part_ns_(static_cast<double>((end - start).count()) / static_cast<double>(kActivityParts)) {}

double Activity::placeOf(LogTime time) const {
  if (!(part_ns_ > 0) || time <= start_) return 0;
  const double place = static_cast<double>((time - start_).count()) / part_ns_;
  return std::min(place, static_cast<double>(kActivityParts));
}

void Activity::addAlone(std::array<Part, kActivityParts>& parts, double place) {
  Part& part = parts[partAt(place)];
  part.messages += 1;
  part.flowed = 1;
}

void Activity::addFlow(double from, double to) {
  if (!(to > from)) {
    // Same time as the last message: one more message, no more time.
    parts_[partAt(from)].messages += 1;
    return;
  }
  for (double at = from; at < to;) {
    const std::size_t number = partAt(at);
    const double until = std::min(to, static_cast<double>(number + 1));
    parts_[number].messages += (until - at) / (to - from);
    parts_[number].flowed += until - at;
    at = until;
  }
}

void Activity::add(LogTime time) {
  const double place = std::max(placeOf(time), last_.value_or(0));
  if (last_) {
    const bool near = place - *last_ < kSilentParts;
    if (near) {
      addFlow(*last_, place);
    } else if (!last_has_neighbour_) {
      addAlone(parts_, *last_);
    }
    last_has_neighbour_ = near;
  }
  last_ = place;
}

Activity::Parts Activity::parts() const {
  std::array<Part, kActivityParts> all = parts_;
  if (last_ && !last_has_neighbour_) addAlone(all, *last_);
  Parts rates{};
  for (std::size_t i = 0; i < kActivityParts; ++i) {
    // Messages of a single moment count for the whole part.
    const double flowed = all[i].flowed > 0 ? std::min(all[i].flowed, 1.0) : 1.0;
    rates[i] = all[i].messages / flowed;
  }
  return rates;
}

std::string activityStrip(const Activity::Parts& parts) {
  static constexpr std::string_view kHeights[] = {"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
  const double most = std::ranges::max(parts);
  std::string line;
  for (const double rate : parts) {
    if (!(rate > 0)) {
      line += "·";
    } else {
      const auto height = static_cast<std::size_t>(std::clamp(std::round(rate / most * 8), 1., 8.));
      line += kHeights[height - 1];
    }
  }
  return line;
}

}  // namespace rocinante
