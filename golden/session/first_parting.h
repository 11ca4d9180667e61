#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/base/result.h"

namespace rocinante {

/// Moments in order, by number, of which two things may be drawn alike or not.
struct PartingQuestion {
  std::size_t moments = 0;
  /// Before it they are known to be alike.
  std::size_t first_possible = 0;
  /// Moments at which things tend to change, in order: looked at first.
  std::vector<std::size_t> probes;
  /// How many moments between two probes are looked at one by one.
  std::size_t most_frames = 2000;
  std::function<Result<bool>(std::size_t)> differs;
};

/// Where two things part, and what is sure of it (docs/programs/golden.md, "bisect").
struct Parting {
  std::optional<std::size_t> first;  ///< differs there; empty: nowhere that was looked
  /// The last moment before `first` that was looked at; they are alike there.
  std::optional<std::size_t> last_alike;
  /// Every moment from `searched_from` to `first` was looked at or is known to be alike.
  bool is_first_since_probe = false;
  std::size_t searched_from = 0;
  std::size_t frames = 0;  ///< moments that were drawn
};

/// Looks at the probes until one differs, then at each moment since the probe before it. Too many
/// of them are halved instead, which finds a moment at which alike turns into different, though
/// perhaps not the first.
Result<Parting> findParting(const PartingQuestion& question);

}  // namespace rocinante
