#include "core/cell/rule_reader.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "core/base/name_hint.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxRules = 1000, kMaxOwnThresholds = 10000;

void readWord(const TomlNode& value, FaultList& faults, CellRule& rule) {
  if (value.kind != TomlNode::Kind::text) {
    faults.error("cell.wrong-kind", value.place,
                 fmt::format("the severity of {} is {}, where a string is expected",
                             quotedInFault(rule.id), nameOf(value.kind)));
  } else if (!readSeverity(value.text, rule)) {
    faults.error("cell.unknown-word", value.place,
                 fmt::format("{} is not a severity", quotedInFault(value.text)),
                 didYouMean(value.text, {"off", "note", "warning", "error"}));
  }
}

/// Into `key` and `threshold`; `of` says whose.
void readThreshold(const TomlNode::Entry& entry, FaultList& faults, const std::string& of,
                   std::string& key, double& threshold) {
  const bool is_number =
      entry.value.kind == TomlNode::Kind::number || entry.value.kind == TomlNode::Kind::integer;
  if (!is_number) {
    faults.error("cell.wrong-kind", entry.value.place,
                 fmt::format("{} of {} is {}, where a number is expected", quotedInFault(entry.key),
                             quotedInFault(of), nameOf(entry.value.kind)));
  } else if (!(entry.value.number > 0.0) || !std::isfinite(entry.value.number)) {
    faults.error(
        "cell.bad-number", entry.value.place,
        fmt::format("{} of {} must be above 0", quotedInFault(entry.key), quotedInFault(of)));
  } else if (!key.empty()) {
    faults.error("cell.unknown-key", entry.place,
                 fmt::format("{} has one threshold, and {} is a second", quotedInFault(of),
                             quotedInFault(entry.key)));
  } else {
    key = entry.key;
    threshold = entry.value.number;
  }
}

void readTable(const TomlNode& value, FaultList& faults, CellRule& rule) {
  for (const TomlNode::Entry& entry : value.entries) {
    if (entry.key.starts_with("x-")) continue;
    if (entry.key == "severity") {
      readWord(entry.value, faults, rule);
    } else if (entry.value.kind != TomlNode::Kind::table) {
      readThreshold(entry, faults, rule.id, rule.threshold_key, rule.threshold);
    } else if (rule.own_thresholds.size() == kMaxOwnThresholds) {
      faults.error(
          "cell.too-many", entry.place,
          fmt::format("{} has more than {} tables", quotedInFault(rule.id), kMaxOwnThresholds));
      return;
    } else {
      CellThreshold own;
      for (const TomlNode::Entry& of_one : entry.value.entries) {
        if (of_one.key.starts_with("x-")) continue;
        readThreshold(of_one, faults, entry.key, own.key, own.value);
      }
      if (!own.key.empty()) rule.own_thresholds.emplace(entry.key, std::move(own));
    }
  }
}

// Ids without quotes are tables within tables to TOML: `packet.bad-name = "off"`.
void readFamily(const TomlNode& table, const std::string& family, FaultList& faults,
                std::vector<CellRule>& rules) {
  for (const TomlNode::Entry& entry : table.entries) {
    if (entry.key.starts_with("x-")) continue;
    CellRule rule;
    rule.id = family + entry.key;
    const bool is_table = entry.value.kind == TomlNode::Kind::table;
    if (is_table && rule.id.find('.') == std::string::npos) {
      readFamily(entry.value, rule.id + ".", faults, rules);
      continue;
    }
    if (rules.size() == kMaxRules) {
      faults.error("cell.too-many", entry.place,
                   fmt::format("[rules] has more than {} rules", kMaxRules));
      return;
    }
    rule.file = faults.file();
    rule.line = entry.place.line;
    rule.column = entry.place.column;
    if (is_table) {
      readTable(entry.value, faults, rule);
    } else {
      readWord(entry.value, faults, rule);
    }
    rules.push_back(std::move(rule));
  }
}

}  // namespace

void readRules(TomlTable& root, Cell& cell) {
  if (!root.table("rules", "[rules]")) return;
  readFamily(*root.node("rules"), "", root.faults(), cell.rules);
}

SourceLimits readSourceLimits(TomlTable& table) {
  SourceLimits limits;
  limits.silence_s = table.positiveNumber("silence_s");
  limits.restate_s = table.positiveNumber("restate_s");
  limits.clock_skew_s = table.positiveNumber("clock_skew_s");
  limits.jitter_ms = table.positiveNumber("jitter_ms");
  return limits;
}

}  // namespace rocinante
