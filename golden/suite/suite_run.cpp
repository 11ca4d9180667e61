#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "core/base/duration_text.h"
#include "golden/suite/suite.h"
#include "golden/suite/suite_case.h"
#include "golden/suite/suite_table.h"

namespace rocinante {
namespace {

constexpr double kMaxLimit = 1e6;
constexpr double kMaxWarp_ms = 2'000;

std::optional<double> limitIn(SuiteTable& table, std::string_view key, double floor) {
  const auto limit = table.number(key);
  if (limit && !(*limit >= floor && *limit <= kMaxLimit)) {
    table.complain(
        *table.node(key),
        fmt::format("`{}` must be at least {}: recordings of one motion differ by so much", key,
                    floor));
  }
  return limit;
}

std::optional<double> signalLimitIn(SuiteTable& table, std::string_view key) {
  const auto limit = table.number(key);
  if (limit && !(*limit >= 0 && std::isfinite(*limit))) {
    table.complain(*table.node(key), fmt::format("`{}` must not be negative", key));
  }
  return limit;
}

constexpr std::array<std::string_view, 7> kLimitKeys = {
    "joint_deg", "position_mm", "turn_deg", "pose_mm", "pose_deg", "event_ms", "signal_share"};

OwnLimits ownLimits(SuiteTable& table) {
  OwnLimits limits;
  limits.joint_deg = limitIn(table, "joint_deg", kRunFloors.joint_deg);
  limits.position_mm = limitIn(table, "position_mm", kRunFloors.position_mm);
  limits.turn_deg = limitIn(table, "turn_deg", kRunFloors.turn_deg);
  limits.pose_mm = limitIn(table, "pose_mm", kRunFloors.position_mm);
  limits.pose_deg = limitIn(table, "pose_deg", kRunFloors.turn_deg);
  limits.event_ms = limitIn(table, "event_ms", kRunFloors.event_ms);
  limits.signal_share = signalLimitIn(table, "signal_share");
  return limits;
}

/// The run's limits, and tables of them by device or DEVICE/JOINT.
void readRunLimits(SuiteTable& table, RunSpec& spec) {
  const TomlNode* node = table.table("limits");
  if (node == nullptr) return;
  SuiteTable limits(*node, table.file(), table.fault());
  const OwnLimits own = ownLimits(limits);
  spec.limits.joint_deg = own.joint_deg.value_or(spec.limits.joint_deg);
  spec.limits.position_mm = own.position_mm.value_or(spec.limits.position_mm);
  spec.limits.turn_deg = own.turn_deg.value_or(spec.limits.turn_deg);
  spec.limits.pose_mm = own.pose_mm;
  spec.limits.pose_deg = own.pose_deg;
  spec.limits.event_ms = own.event_ms.value_or(spec.limits.event_ms);
  spec.limits.signal_share = own.signal_share.value_or(spec.limits.signal_share);
  spec.limits.link_positions = own.position_mm.has_value();
  spec.limits.link_turns = own.turn_deg.has_value();
  for (const TomlNode::Entry& entry : node->entries) {
    if (std::ranges::count(kLimitKeys, entry.key) > 0 || entry.key.starts_with("x-")) continue;
    if (entry.value.kind != TomlNode::Kind::table) {
      table.complain(entry.value,
                     fmt::format("`{}` is not a limit; limits of a device, joint or signal are a "
                                 "table: \"arm/elbow\" = {{ joint_deg = 0.5 }}",
                                 entry.key));
      continue;
    }
    SuiteTable its(entry.value, table.file(), table.fault());
    its.onlyKeys({"joint_deg", "position_mm", "turn_deg", "pose_mm", "pose_deg", "event_ms",
                  "signal", "signal_share"});
    OwnLimits& of_item = spec.own_limits[entry.key] = ownLimits(its);
    of_item.signal = signalLimitIn(its, "signal");
    if (of_item.signal && !entry.key.starts_with("signal ")) {
      table.complain(*its.node("signal"),
                     "`signal` is a limit of one signal, in its unit and in a table of its name, "
                     "such as \"signal arm load\" = { signal = 5 }");
    }
  }
}

std::optional<Nanoseconds> momentIn(SuiteTable& table, std::string_view key) {
  const auto text = table.text(key);
  if (!text) return std::nullopt;
  const auto moment = parseDuration(*text);
  if (moment.ok()) return *moment;
  table.complain(*table.node(key),
                 fmt::format("`{}` must be a time from the origin, such as \"2.5s\"", key));
  return std::nullopt;
}

void readRunMasks(SuiteTable& table, RunSpec& spec) {
  const TomlNode* node = table.node("mask");
  if (node == nullptr) return;
  if (node->kind != TomlNode::Kind::array) {
    table.complain(*node,
                   "`mask` is a list of items and of { item = ..., from = ..., until = ... }");
    return;
  }
  for (const TomlNode& item : node->items) {
    RunMask& mask = spec.masks.emplace_back();
    if (item.kind == TomlNode::Kind::text) {
      mask.item = item.text;
    } else if (item.kind == TomlNode::Kind::table) {
      SuiteTable its(item, table.file(), table.fault());
      its.onlyKeys({"item", "from", "until"});
      if (its.has("item")) mask.item = its.text("item").value_or("");
      mask.from = momentIn(its, "from").value_or(mask.from);
      mask.until = momentIn(its, "until").value_or(mask.until);
      if (mask.until < mask.from) its.complainHere("`until` must not be before `from`");
    } else {
      table.complain(item, "a mask is an item or { item = ..., from = ..., until = ... }");
    }
    if (mask.item.empty()) table.complain(item, "a mask's item must not be empty");
  }
}

}  // namespace

SuiteRun readSuiteRun(SuiteTable& table) {
  table.onlyKeys({"name", "align", "warp_ms", "limits", "mask", "tags"});
  SuiteRun run;
  run.name = table.text("name").value_or("");
  if (!isCaseName(run.name)) {
    table.complainHere("a run needs a `name` of at most 100 letters, digits, `_`, `-` and `.`");
  }
  if (const auto align = table.text("align")) {
    if (const auto named = runAlignNamed(*align)) {
      run.spec.align = *named;
    } else {
      table.complain(*table.node("align"), "`align` must be \"origin\", \"events\" or \"warp\"");
    }
  }
  if (const auto warp = table.number("warp_ms")) {
    if (run.spec.align != RunAlign::warp) {
      table.complain(*table.node("warp_ms"), "`warp_ms` needs `align = \"warp\"`");
    } else if (!(*warp > 0 && *warp <= kMaxWarp_ms)) {
      table.complain(*table.node("warp_ms"), "`warp_ms` must be above 0 and at most 2000");
    } else {
      run.spec.warp = Nanoseconds(std::llround(*warp * 1e6));
    }
  }
  readRunLimits(table, run.spec);
  readRunMasks(table, run.spec);
  if (table.has("tags")) run.tags = table.texts("tags");
  return run;
}

}  // namespace rocinante
