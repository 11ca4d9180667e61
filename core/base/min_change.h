#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace rocinante {

/// Which changes a relay holds back: `--min-change`, `min-change=` of a subscription. Those of
/// joints and poses wait until the device rests; a number of a signal waits for one that differs
/// enough from what was sent last, or for a restatement. A plain value.
struct MinChange {
  /// Of the signals whose `PATH NAME` matches the pattern (core/base/pattern.h).
  struct OfSignals {
    std::string pattern;
    double least = 0;  ///< in the signal's own unit
    bool operator==(const OfSignals&) const = default;
  };

  double joint = 0;     ///< metres or radians
  double position = 0;  ///< metres
  double turn = 0;      ///< radians
  std::vector<OfSignals> signals{};

  bool any() const { return joint > 0 || position > 0 || turn > 0 || !signals.empty(); }
  /// The greatest of the patterns that match; 0: every number passes.
  double ofSignal(std::string_view path_and_name) const;

  /// `joint=X`, `position=X`, `turn=X`, `signal=X` (all signals) or `signal PATTERN=X`, X above 0.
  /// bad_argument with what is wrong, which continues the option's name, and the text.
  Status add(std::string_view text);
  /// The same, separated by commas.
  Status addAll(std::string_view text);
  /// Holds back what either holds back.
  void join(const MinChange& other);
};

}  // namespace rocinante
