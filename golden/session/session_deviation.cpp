#include "golden/session/session_deviation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "core/base/hash.h"
#include "core/cell/posed_scene.h"
#include "core/packet/item_text.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxMoments = 100'000;
/// Most values of both sessions together: 400 MB.
constexpr std::size_t kMaxValues = 50'000'000;

constexpr double kAbsent = std::numeric_limits<double>::quiet_NaN();

enum class ItemKind { measure, fact };

/// An item's values in both sessions, by sample. A fact is a number that represents its text.
struct ItemSeries {
  ItemKind kind = ItemKind::measure;
  std::string unit;
  std::vector<double> a, b;
};

using SeriesByItem = std::map<std::string, ItemSeries, std::less<>>;

double factNumber(const std::string& text) {
  const auto hash = xxh3(bytesOf(text));
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < 6; ++i)
    number = number << 8U | std::to_integer<std::uint64_t>(hash[i]);
  return static_cast<double>(number);  // 48 bits: exact
}

/// Records all items of a state at one sample of one side.
class SampleWriter {
 public:
  SampleWriter(SeriesByItem& series, std::size_t samples, std::vector<double> ItemSeries::*side)
      : series_(series), samples_(samples), side_(side) {}

  void write(const Cell& cell, const SessionState& state, std::size_t sample) {
    sample_ = sample;
    const PosedScene scene = poseScene(cell, state);
    for (const PosedDevice& device : scene.devices) writeDevice(device, state);
    for (const auto& [path, item] : state.visibility()) {
      fact(pathName("show ", path), visibilityText(path, item.value));
    }
    for (const auto& [path, item] : state.colors()) {
      fact(pathName("color ", path), colorText(path, item.value));
    }
    for (const auto& [key, drawing] : state.drawings()) writeDrawing(key, drawing);
  }

 private:
  static std::string pathName(const char* what, const Path& path) {
    return what + (path.is_layer ? "layer/" + path.first
                                 : path.first + (path.second.empty() ? "" : "/" + path.second));
  }

  void put(const std::string& item, ItemKind kind, std::string_view unit, double value) {
    ItemSeries& its = series_[item];
    if (its.a.empty()) {
      its.kind = kind;
      its.unit = unit;
      its.a.assign(samples_, kAbsent);
      its.b.assign(samples_, kAbsent);
    }
    (its.*side_)[sample_] = value;
  }
  void measure(const std::string& item, std::string_view unit, double value) {
    put(item, ItemKind::measure, unit, value);
  }
  void fact(const std::string& item, const std::string& text) {
    put(item, ItemKind::fact, "", factNumber(text));
  }

  void writeDevice(const PosedDevice& device, const SessionState& state) {
    fact("device " + device.name, device.model->name);
    const auto said = state.devices().find(device.name);
    const DeviceState* device_state = said == state.devices().end() ? nullptr : &said->second;
    const JointVector joints = jointsOf(*device.model, device_state);
    for (std::size_t i = 0; i < device.model->joints.size(); ++i) {
      const Joint& joint = device.model->joints[i];
      const std::size_t count = valueCount(joint.type);
      for (std::size_t component = 0; component < count; ++component) {
        const bool is_angle =
            count == 1 ? joint.type != JointType::prismatic : count == 3 && component == 2;
        const std::string suffix = count == 1 ? "" : "." + std::to_string(component);
        const char* unit = is_angle ? "rad" : count == 7 && component > 2 ? "" : "m";
        measure(device.name + "/" + joint.name + suffix, unit,
                joints.values[joints.first_value[i] + component]);
      }
    }
    if (device_state == nullptr || !device_state->pose) return;
    // As received, not in world space: a device's carrier is compared separately.
    const Pose& pose = device_state->pose->value.pose;
    const Path& carrier = device_state->pose->value.carrier;
    fact("carrier of " + device.name, carrier.first + "/" + carrier.second);
    measure(device.name + ".x", "m", pose.position.x);
    measure(device.name + ".y", "m", pose.position.y);
    measure(device.name + ".z", "m", pose.position.z);
    // q and -q are the same orientation.
    const double sign = pose.orientation.w < 0 ? -1 : 1;
    measure(device.name + ".qx", "", sign * pose.orientation.x);
    measure(device.name + ".qy", "", sign * pose.orientation.y);
    measure(device.name + ".qz", "", sign * pose.orientation.z);
    measure(device.name + ".qw", "", sign * pose.orientation.w);
  }

  void writeDrawing(const std::pair<std::string, std::string>& key, const Drawing& drawing) {
    std::string text;
    for (std::size_t part = 0; part < drawing.parts.size(); ++part) {
      text += drawing.parts[part] ? drawingText(key.second, drawing, part) : "gap";
    }
    fact("drawing " + key.first + "/" + key.second, text);
  }

  SeriesByItem& series_;
  std::size_t samples_;
  std::vector<double> ItemSeries::*side_;
  std::size_t sample_ = 0;
};

/// Distance of `value` from the range of `others` from `first` to `last`; 0 inside.
double distanceFrom(double value, const std::vector<double>& others, std::size_t first,
                    std::size_t last, ItemKind kind) {
  double least = std::numeric_limits<double>::infinity();
  double lowest = least;
  double highest = -least;
  bool has_absent = false;
  for (std::size_t i = first; i <= last; ++i) {
    if (std::isnan(others[i])) {
      has_absent = true;
      continue;
    }
    lowest = std::min(lowest, others[i]);
    highest = std::max(highest, others[i]);
    least = std::min(least, std::abs(others[i] - value));
  }
  if (std::isnan(value)) return has_absent ? 0 : std::numeric_limits<double>::infinity();
  if (kind == ItemKind::fact) return least == 0 ? 0 : std::numeric_limits<double>::infinity();
  // A value that goes from below to above passes everything in between.
  return value >= lowest && value <= highest ? 0 : least;
}

double limitOf(const ItemSeries& series, const SessionLimits& limits) {
  if (series.kind == ItemKind::fact) return 0;
  return series.unit == "rad" ? limits.radians : limits.metres;
}

/// The slack in samples. As many samples are recorded after the last judged one, for values that
/// arrive later in one session.
std::size_t reachOf(const SessionLimits& limits, const SessionDeviation& found) {
  const auto reach = (limits.slack + found.step - Nanoseconds(1)) / found.step;
  return std::min(static_cast<std::size_t>(reach), found.samples);
}

class DeviationFinder {
 public:
  DeviationFinder(const SessionLimits& limits, SessionDeviation& found)
      : limits_(limits), found_(found) {
    reach_ = reachOf(limits, found);
  }

  void judge(const std::string& item, const ItemSeries& series) {
    const double limit = limitOf(series, limits_);
    Deviation deviation{item, series.unit, 0.0, {}, {}};
    bool is_beyond = false;
    for (std::size_t i = 0; i < found_.samples; ++i) {
      const std::size_t first = i < reach_ ? 0 : i - reach_;
      const std::size_t last = i + reach_;
      const double apart = std::max(distanceFrom(series.a[i], series.b, first, last, series.kind),
                                    distanceFrom(series.b[i], series.a, first, last, series.kind));
      const LogTime moment = found_.from + found_.step * static_cast<std::int64_t>(i);
      if (apart > limit && !is_beyond) {
        is_beyond = true;
        deviation.first_at = moment;
      }
      if (deviation.largest && apart > *deviation.largest) {
        deviation.largest_at = moment;
        // Presence has no numeric measure.
        if (std::isinf(apart)) {
          deviation.largest.reset();
        } else {
          deviation.largest = apart;
        }
      }
    }
    if (is_beyond) {
      found_.beyond.push_back(std::move(deviation));
    } else if (deviation.largest && limit > 0 && *deviation.largest / limit > nearest_) {
      nearest_ = *deviation.largest / limit;
      found_.largest_within = std::move(deviation);
    }
  }

 private:
  const SessionLimits& limits_;
  SessionDeviation& found_;
  std::size_t reach_ = 0;
  double nearest_ = 0;
};

}  // namespace

Result<SessionDeviation> compareSessions(const Cell& cell, Timeline& a, Timeline& b,
                                         const EventAlignment& alignment,
                                         const SessionLimits& limits, StateDamage& damage) {
  SessionDeviation found;
  // The common range; b's ends are converted to a's time by the inverse alignment.
  EventAlignment back;
  for (const MatchedEvent& event : alignment.matched) {
    back.matched.push_back({event.text, event.b, event.a});
  }
  back.anchor_a = alignment.anchor_b;
  back.anchor_b = alignment.anchor_a;
  found.from = std::max(a.start(), back.inB(b.start()));
  found.until = std::min(a.end(), back.inB(b.end()));
  if (found.until < found.from) {
    return Error{ErrorKind::not_found, "the sessions have no time in common, aligned by events",
                 b.log().name()};
  }
  // Values at one moment, to compute how many moments fit in memory.
  SeriesByItem probe;
  const auto first_state = a.stateAt(found.from + (found.until - found.from) / 2, &damage);
  if (!first_state.ok()) return first_state.error();
  SampleWriter(probe, 1, &ItemSeries::a).write(cell, **first_state, 0);
  const std::size_t most =
      std::max<std::size_t>(16, std::min(kMaxMoments, kMaxValues / (2 * probe.size() + 2)));
  const Nanoseconds span = found.until - found.from;
  found.step = std::max({limits.step, Nanoseconds(1), span / static_cast<std::int64_t>(most)});
  found.samples = static_cast<std::size_t>(span / found.step) + 1;

  SeriesByItem series;
  const std::size_t taken = found.samples + reachOf(limits, found);
  SampleWriter into_a(series, taken, &ItemSeries::a);
  SampleWriter into_b(series, taken, &ItemSeries::b);
  for (std::size_t i = 0; i < taken; ++i) {
    const LogTime moment = found.from + found.step * static_cast<std::int64_t>(i);
    const auto state_a = a.stateAt(std::min(moment, a.end()), &damage);
    if (!state_a.ok()) return state_a.error();
    into_a.write(cell, **state_a, i);
    const auto state_b = b.stateAt(std::min(alignment.inB(moment), b.end()), &damage);
    if (!state_b.ok()) return state_b.error();
    into_b.write(cell, **state_b, i);
  }
  // Also damage between the samples, where a value may have differed.
  for (const auto& [session, from, until] :
       {std::tuple(&a, found.from, found.until),
        std::tuple(&b, alignment.inB(found.from), alignment.inB(found.until))}) {
    if (session->log().unreadable().empty()) continue;
    if (Status told = session->addDamage(from, until, damage); !told) return told.error();
  }
  found.items = series.size();
  DeviationFinder finder(limits, found);
  for (const auto& [item, its] : series) finder.judge(item, its);
  std::ranges::stable_sort(found.beyond, {}, &Deviation::first_at);
  return found;
}

Result<LogTime> nearestMoment(const Cell& cell, Timeline& a, LogTime in_a, Timeline& b,
                              LogTime in_b, const std::vector<LogTime>& candidates,
                              const SessionLimits& limits) {
  SeriesByItem series;
  const auto state_a = a.stateAt(in_a);
  if (!state_a.ok()) return state_a.error();
  SampleWriter(series, candidates.size(), &ItemSeries::a).write(cell, **state_a, 0);
  SampleWriter into_b(series, candidates.size(), &ItemSeries::b);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const auto state_b = b.stateAt(candidates[i]);
    if (!state_b.ok()) return state_b.error();
    into_b.write(cell, **state_b, i);
  }
  struct Apart {
    std::size_t facts = 0;  ///< and items that only one of them has
    double most = 0;
    Nanoseconds away{0};
    auto operator<=>(const Apart&) const = default;
  };
  std::vector<Apart> apart(candidates.size());
  for (const auto& [item, its] : series) {
    const double limit = std::max(limitOf(its, limits), 1e-12);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const double away = std::abs(its.a.front() - its.b[i]);
      if (std::isnan(its.a.front()) && std::isnan(its.b[i])) continue;
      if (its.kind == ItemKind::fact ? away != 0 : std::isnan(away)) {
        ++apart[i].facts;
      } else if (its.kind == ItemKind::measure) {
        apart[i].most = std::max(apart[i].most, away / limit);
      }
    }
  }
  LogTime best = in_b;
  std::optional<Apart> least;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    apart[i].away = std::chrono::abs(candidates[i] - in_b);
    if (least && (apart[i] <=> *least) >= 0) continue;
    least = apart[i];
    best = candidates[i];
  }
  return best;
}

}  // namespace rocinante
