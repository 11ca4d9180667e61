#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/cell/cell.h"
#include "viewer/ui/live/source_watch.h"

namespace rocinante {

/// A line of the list of sources: one that speaks or spoke, or that the cell expects.
struct SourceRow {
  std::string name;
  const LiveSource* live = nullptr;  ///< borrowed; null: expected, and never heard
  Nanoseconds silent{};              ///< of one that was heard
  bool is_silent = false;            ///< for longer than it should be, or never heard
  bool off_rate = false;             ///< speaks, and not as often as the cell expects
  std::optional<std::pair<double, double>> wanted_hz;
};

/// By name. One is silent when it said nothing for as long as the cell's `silence_s` has it, else
/// for 3 s. `now`: on the clock of LiveSource::heard. Pure.
std::vector<SourceRow> sourceRows(std::span<const LiveSource> live, const Cell& cell,
                                  SteadyTime now);

/// "now" below a second, then whole seconds, minutes or hours: a figure that stands still.
std::string ageText(Nanoseconds age);

}  // namespace rocinante
