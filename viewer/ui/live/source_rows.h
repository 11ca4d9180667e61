#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/cell/cell.h"
#include "viewer/ui/live/source_watch.h"

namespace rocinante {

/// A row of the list of sources: one that sent packets, or that the cell expects.
struct SourceRow {
  std::string name;
  const LiveSource* live = nullptr;  ///< borrowed; null: expected, but never received
  Nanoseconds silent{};              ///< of a received source
  bool is_silent = false;            ///< for too long, or never received
  bool off_rate = false;             ///< sends at a different rate than the cell expects
  std::optional<std::pair<double, double>> wanted_hz;
};

/// Rows by name. A source is silent after the cell's `silence_s`, else after 3 s. `now`: on the
/// clock of LiveSource::heard. Pure.
std::vector<SourceRow> sourceRows(std::span<const LiveSource> live, const Cell& cell,
                                  SteadyTime now);

/// "now" below a second, then whole seconds, minutes or hours: a figure that does not flicker.
std::string ageText(Nanoseconds age);

}  // namespace rocinante
