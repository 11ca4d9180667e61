#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/clearance/clearance_gauge.h"

namespace rocinante {

/// The distances of a cell's clearances as columns of a table: "clearance/NAME/DEVICE/DEVICE", in
/// metres, as `check` rounds them; 0 is penetrating, NaN where a device is not there. As with
/// SessionTable the columns are found first, then rows are filled. The cell must outlive it.
class ClearanceColumns {
 public:
  /// Of two devices one must match one of the patterns; without any, all are measured.
  ClearanceColumns(const Cell& cell, const std::vector<std::string>& devices);

  void notice(const SessionState& state) { gauge_.notice(state); }
  void layOut();
  /// Valid after layOut().
  const std::vector<std::string>& columns() const { return columns_; }
  /// `row` is as long as columns().
  void fill(const SessionState& state, std::span<double> row);

  /// What is missing: sentences, after layOut().
  std::vector<std::string> gaps() const;

 private:
  const Cell& cell_;
  bool has_patterns_;
  ClearanceGauge gauge_;
  std::vector<std::string> columns_;
  std::vector<double> distances_m_;
};

}  // namespace rocinante
