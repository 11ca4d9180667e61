#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/series/placed_links.h"
#include "core/session/moment_walk.h"

namespace rocinante {

/// Poses of links as columns of a table: `DEVICE/LINK:x` to `:qw` in the world, or
/// `DEVICE/LINK:x in PATH`; metres and a unit quaternion, NaN where a device is not there. The cell
/// must outlive it.
class LinkColumns {
 public:
  /// `links`: each DEVICE/LINK; `frame`: DEVICE or DEVICE/LINK, empty: the world. bad_argument or
  /// not_found for one that is neither of the cell nor of the session at `moment`.
  static Result<LinkColumns> of(const Cell& cell, const std::vector<std::string>& links,
                                const std::string& frame, MomentWalk& session, LogTime moment);

  const std::vector<std::string>& columns() const { return columns_; }
  /// True if something that moves one of them, or carries what does, was written at `moment`.
  bool wereMoved(const SessionState& state, LogTime moment);
  /// `row` is as long as columns().
  void fill(const SessionState& state, std::span<double> row);

 private:
  explicit LinkColumns(const Cell& cell) : placed_(cell) {}

  PlacedLinks placed_;
  std::vector<std::string> columns_;
  bool knows_carriers_ = false;
};

}  // namespace rocinante
