#include "core/behaviour/run_spec.h"

#include <algorithm>

#include "core/base/duration_text.h"
#include "core/base/pattern.h"
#include "core/packet/item_text.h"

namespace rocinante {

std::string_view nameOf(RunAlign align) {
  switch (align) {
    case RunAlign::origin:
      return "origin";
    case RunAlign::events:
      return "events";
    case RunAlign::warp:
      return "warp";
  }
  return "events";
}

std::optional<RunAlign> runAlignNamed(std::string_view name) {
  for (const RunAlign align : {RunAlign::origin, RunAlign::events, RunAlign::warp}) {
    if (nameOf(align) == name) return align;
  }
  return std::nullopt;
}

std::string deviceOfItem(std::string_view item) {
  constexpr std::string_view kSignal = "signal ";
  std::string_view path = item;
  const std::size_t blank = item.starts_with(kSignal) ? item.find(' ', kSignal.size()) : item.npos;
  if (blank != item.npos) {
    path = item.substr(kSignal.size(), blank - kSignal.size());
    // Names in packets are percent-encoded. This is asked for each value of a run with masks.
    if (path.find('%') != std::string_view::npos) {
      if (const auto signal = signalNamed(item)) return signal->device;
    }
  }
  return std::string(path.substr(0, path.find('/')));
}

std::string maskText(const RunMask& mask) {
  std::string text = mask.item;
  if (mask.from != Nanoseconds::min()) text += " from " + secondsText(mask.from) + " s";
  if (mask.until != Nanoseconds::max()) text += " until " + secondsText(mask.until) + " s";
  return text;
}

RunLimits RunSpec::limitsOf(std::string_view item) const {
  RunLimits found = limits;
  const auto apply = [&](std::string_view name) {
    const auto own = own_limits.find(name);
    if (own == own_limits.end()) return;
    found.joint_deg = own->second.joint_deg.value_or(found.joint_deg);
    found.position_mm = own->second.position_mm.value_or(found.position_mm);
    found.turn_deg = own->second.turn_deg.value_or(found.turn_deg);
    if (own->second.pose_mm) found.pose_mm = own->second.pose_mm;
    if (own->second.pose_deg) found.pose_deg = own->second.pose_deg;
    if (own->second.signal) found.signal = own->second.signal;
    // A share of its own is nearer than a limit of its device.
    if (own->second.signal_share) {
      found.signal_share = *own->second.signal_share;
      found.signal = own->second.signal;
    }
    found.event_ms = own->second.event_ms.value_or(found.event_ms);
    found.link_positions = found.link_positions || own->second.position_mm;
    found.link_turns = found.link_turns || own->second.turn_deg;
  };
  const std::string device = deviceOfItem(item);
  apply(device);
  if (device != item) apply(item);
  return found;
}

namespace {

bool covers(const RunMask& mask, std::string_view item) {
  return patternMatches(mask.item, item) || patternMatches(mask.item, deviceOfItem(item));
}

}  // namespace

bool RunSpec::isMasked(std::string_view item, Nanoseconds since_origin) const {
  return std::ranges::any_of(masks, [&](const RunMask& mask) {
    return since_origin >= mask.from && since_origin <= mask.until && covers(mask, item);
  });
}

bool RunSpec::isMaskedThroughout(std::string_view item) const {
  return std::ranges::any_of(masks, [&](const RunMask& mask) {
    return mask.from == Nanoseconds::min() && mask.until == Nanoseconds::max() &&
           covers(mask, item);
  });
}

}  // namespace rocinante
