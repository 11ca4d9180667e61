#include <fmt/format.h>

#include <algorithm>

#include "core/cell/cell_sections.h"
#include "core/document/fault_list.h"
#include "core/packet/packet_text.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxSignals = 4096, kMaxWords = 1024;
constexpr std::string_view kArrow = "->";

/// PATH: DEVICE, DEVICE/LINK or "-".
bool readPath(TomlTable& table, const Cell& cell, CellSignal& signal) {
  const auto path = table.requiredText("path");
  if (!path) return false;
  if (*path == "-") return true;
  const std::size_t slash = path->find('/');
  signal.device = path->substr(0, slash);
  if (slash != std::string::npos) signal.link = path->substr(slash + 1);
  const CellDevice* const device = cell.findDevice(signal.device);
  const bool is_ghost = std::ranges::any_of(cell.sources, [&](const CellSource& source) {
    return source.ghost_of.contains(signal.device);
  });
  if (device == nullptr && !is_ghost) {
    table.error("cell.unknown-device", "path",
                fmt::format("[[signal]] names {}, which the cell does not have",
                            quotedInFault(signal.device)),
                deviceHint(table, cell, signal.device));
    return false;
  }
  const Model* const model = device == nullptr ? nullptr : cell.modelOf(*device);
  if (slash == std::string::npos || model == nullptr || model->findLink(signal.link)) return true;
  table.error("cell.unknown-link", "path",
              fmt::format("device {} has no link {}", quotedInFault(signal.device),
                          quotedInFault(signal.link)));
  return false;
}

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

/// "auto -> manual"; both ends must be in `values`, where the cell has them.
void readTransitions(TomlTable& table, CellSignal& signal) {
  for (const std::string& text : table.texts("transitions")) {
    const std::size_t arrow = text.find(kArrow);
    const std::string_view view = text;
    const std::string from(trimmed(view.substr(0, arrow)));
    const std::string to(arrow == std::string::npos ? std::string_view()
                                                    : trimmed(view.substr(arrow + kArrow.size())));
    const auto isKnown = [&](const std::string& value) {
      return signal.values.empty() ||
             std::ranges::find(signal.values, value) != signal.values.end();
    };
    if (from.empty() || to.empty() || to.find(kArrow) != std::string::npos) {
      table.error("cell.unknown-word", "transitions",
                  fmt::format("{} is no transition", quotedInFault(text)), "\"auto -> manual\"");
    } else if (!isKnown(from) || !isKnown(to)) {
      table.error(
          "cell.unknown-word", "transitions",
          fmt::format("{} is not among `values`", quotedInFault(isKnown(from) ? to : from)));
    } else {
      signal.transitions.emplace_back(from, to);
    }
  }
}

}  // namespace

void readSignals(TomlTable& root, Cell& cell) {
  for (TomlTable& table : root.tables("signal", "[[signal]]")) {
    CellSignal signal;
    const bool has_path = readPath(table, cell, signal);
    const auto name = table.requiredText("name");
    if (const auto unit = table.text("unit")) {
      signal.unit = *unit;
      if (!isUnit(*unit)) {
        table.error("cell.bad-name", "unit",
                    fmt::format("{} is not 1 to 32 printable ASCII characters without spaces and "
                                "quotes",
                                quotedInFault(*unit)),
                    unitHint(*unit));
      }
    }
    signal.label = table.text("label").value_or("");
    signal.range = table.range("range");
    signal.jump = table.positiveNumber("jump");
    signal.stuck_s = table.positiveNumber("stuck_s");
    signal.rate_hz = table.range("rate_hz");
    if (signal.rate_hz && signal.rate_hz->first < 0) {
      table.error("cell.bad-range", "rate_hz", "`rate_hz` must not be below 0");
      signal.rate_hz.reset();
    }
    signal.values = table.texts("values");
    readTransitions(table, signal);
    signal.optional = table.flag("optional").value_or(false);
    table.finish();
    if (signal.values.size() > kMaxWords || signal.transitions.size() > kMaxWords ||
        cell.signals.size() >= kMaxSignals) {
      table.faults().error("cell.too-many", table.place(),
                           fmt::format("a cell has at most {} [[signal]]s, each with {} values and "
                                       "{} transitions",
                                       kMaxSignals, kMaxWords, kMaxWords));
      return;
    }
    if (!has_path || !name) continue;
    signal.name = *name;
    if (signal.name.empty()) {
      table.error("cell.empty", "name", "`name` is empty");
      continue;
    }
    cell.signals.push_back(std::move(signal));
  }
}

}  // namespace rocinante
