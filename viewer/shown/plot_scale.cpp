#include "viewer/shown/plot_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/pattern.h"
#include "core/series/derived_value.h"

namespace rocinante {
namespace {

constexpr double kDegreesPerRadian = 57.29577951308232;

PlotUnit unitOf(const Joint& joint, std::string_view part) {
  switch (joint.type) {
    case JointType::revolute:
    case JointType::continuous:
      return PlotUnit::degrees;
    case JointType::prismatic:
      return PlotUnit::metres;
    case JointType::planar:
      return part.ends_with(".yaw") ? PlotUnit::degrees : PlotUnit::metres;
    case JointType::floating:
      return part.ends_with(".x") || part.ends_with(".y") || part.ends_with(".z")
                 ? PlotUnit::metres
                 : PlotUnit::quaternion;
    case JointType::fixed:
      break;
  }
  return PlotUnit::other;
}

PlotValue jointValue(const SeriesKey& key, const Model& model) {
  PlotValue value;
  value.series = key;
  const auto named = model.findJoint(key.part);
  const auto stated = model.findJointValue(key.part);
  if (!named && !stated) return value;
  const Joint& joint = model.joints[named ? *named : stated->joint];
  value.unit = unitOf(joint, key.part);
  const double shown = value.unit == PlotUnit::degrees ? kDegreesPerRadian : 1;
  value.factor = shown;
  if (joint.limits && valueCount(joint.type) == 1 && joint.type != JointType::continuous) {
    value.lower = joint.limits->lower * shown;
    value.upper = joint.limits->upper * shown;
  }
  // A chain of joints that follow one another ends, since models have no circles.
  const Joint* follower = &joint;
  double multiplier = 1;
  for (std::size_t steps = 0; follower->mimic && steps <= model.joints.size(); ++steps) {
    value.offset += multiplier * follower->mimic->offset * shown;
    multiplier *= follower->mimic->multiplier;
    follower = &model.joints[follower->mimic->joint];
  }
  if (follower != &joint) {
    value.series.part = follower->name;
    value.factor = multiplier * shown;
  }
  return value;
}

}  // namespace

PlotValue plotValue(const SeriesKey& key, const Model* model) {
  PlotValue value;
  value.series = key;
  switch (key.kind) {
    case SeriesKey::Kind::joint:
      return model == nullptr ? value : jointValue(key, *model);
    case SeriesKey::Kind::pose:
    case SeriesKey::Kind::link:
      value.unit = key.part.size() == 1 ? PlotUnit::metres : PlotUnit::quaternion;
      return value;
    case SeriesKey::Kind::signal:
    case SeriesKey::Kind::derived:
      return value;
    case SeriesKey::Kind::rate:
    case SeriesKey::Kind::loss:
      value.unit = PlotUnit::per_second;
      return value;
  }
  return value;
}

PlotValue plotValue(const SeriesKey& key, const PosedScene& scene) {
  const auto derivation = derivationOf(key);
  if (!derivation) {
    const PosedDevice* const device = key.isOfDevice() ? scene.findDevice(key.name) : nullptr;
    return plotValue(key, device == nullptr ? nullptr : device->model);
  }
  PlotValue value = plotValue(derivation->of[0], scene);
  value.series = key;
  value.offset = 0;
  value.lower.reset();
  value.upper.reset();
  if (derivation->how == Derivation::How::rate) ++value.per_seconds;
  if (derivation->how != Derivation::How::difference) return value;
  const PlotValue second = plotValue(derivation->of[1], scene);
  if (second.unit != value.unit) {
    value.unit = PlotUnit::other;
    value.factor = 1;
  }
  return value;
}

void useSignalRange(PlotValue& value, const std::vector<CellSignal>& expected,
                    std::string_view unit) {
  const SeriesKey& key = value.series;
  const auto found = std::ranges::find_if(expected, [&](const CellSignal& each) {
    return each.device == key.name && each.link == key.link && patternMatches(each.name, key.part);
  });
  if (key.kind != SeriesKey::Kind::signal || found == expected.end() || !found->range) return;
  if (!found->unit.empty() && found->unit != unit) return;
  value.lower = found->range->first;
  value.upper = found->range->second;
}

PlotScale plotScale(double low, double high, PlotUnit unit, int ticks) {
  PlotScale scale;
  if (!(low <= high)) {
    low = -1;
    high = 1;
  }
  // What a float of that size can tell apart is not a movement.
  const double least = std::max({std::abs(low) * 1e-5, std::abs(high) * 1e-5, 1e-6});
  if (high - low < least) {
    const double middle = low / 2 + high / 2;
    const double half = unit == PlotUnit::degrees ? std::max(1.0, least) : std::max(0.01, least);
    low = middle - half;
    high = middle + half;
  }
  if (unit == PlotUnit::per_second) low = std::min(low, 0.0);
  const double margin = (high - low) * 0.06;
  scale.low = unit == PlotUnit::per_second ? low : low - margin;
  scale.high = high + margin;
  scale.millimetres =
      unit == PlotUnit::metres && std::max(std::abs(scale.low), std::abs(scale.high)) < 0.5;
  const double times = scale.millimetres ? 1000 : 1;
  const double rough = (scale.high - scale.low) * times / std::max(ticks, 1);
  double power = 1;
  int decimals = 0;
  while (power > rough) {
    power /= 10;
    ++decimals;
  }
  while (power * 10 <= rough) power *= 10;
  double step = power;
  for (const int factor : {2, 5, 10}) {
    if (step < rough) step = power * factor;
  }
  if (step >= power * 10 && decimals > 0) --decimals;
  scale.step = step / times;
  scale.decimals = decimals;
  scale.first = std::ceil(scale.low / scale.step) * scale.step;
  return scale;
}

std::string perText(int per_seconds) {
  if (per_seconds == 0) return {};
  return per_seconds == 1 ? "/s" : per_seconds == 2 ? "/s²" : fmt::format("/s^{}", per_seconds);
}

std::string unitText(PlotUnit unit, const PlotScale& scale) {
  const std::string per = perText(scale.per_seconds);
  switch (unit) {
    case PlotUnit::degrees:
      return "°" + per;
    case PlotUnit::metres:
      return (scale.millimetres ? "mm" : "m") + per;
    case PlotUnit::per_second:
      return "/s";
    case PlotUnit::quaternion:
    case PlotUnit::other:
      break;
  }
  return per;
}

std::string plotText(double shown, PlotUnit unit, const PlotScale& scale) {
  const double number = scale.millimetres ? shown * 1000 : shown;
  const int least = unit == PlotUnit::per_second || scale.millimetres ? 1
                    : unit == PlotUnit::degrees                       ? 2
                                                                      : 3;
  const std::string text = fmt::format("{:.{}f}", number, std::max(scale.decimals + 1, least));
  const std::string name = unitText(unit, scale);
  return unit == PlotUnit::degrees || name.empty() ? text + name : text + " " + name;
}

void includeLimits(const PlotValue& value, double& low, double& high) {
  const double near = (high - low) * 0.35;
  if (value.upper && *value.upper > high && *value.upper < high + near) high = *value.upper;
  if (value.lower && *value.lower<low&& * value.lower> low - near) low = *value.lower;
}

std::optional<std::pair<double, double>> rangeOf(const std::vector<ValueColumn>& columns,
                                                 const PlotValue& value) {
  std::optional<std::pair<double, double>> range;
  const auto include = [&](float stated) {
    const double shown = value.shown(static_cast<double>(stated));
    if (!std::isfinite(shown)) return;  // beyond single precision
    if (!range) range.emplace(shown, shown);
    range->first = std::min(range->first, shown);
    range->second = std::max(range->second, shown);
  };
  for (const ValueColumn& column : columns) {
    if (column.bin.hasSample()) {
      include(column.bin.low);
      include(column.bin.high);
    } else if (column.held) {
      include(*column.held);
    }
  }
  return range;
}

}  // namespace rocinante
