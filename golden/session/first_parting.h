#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/base/result.h"

namespace rocinante {

/// Numbered moments at which two sides are equal or different.
struct PartingQuestion {
  std::size_t moments = 0;
  /// Moments before it are known to be equal.
  std::size_t first_possible = 0;
  /// Moments at which changes are likely, in order; compared first.
  std::vector<std::size_t> probes;
  /// Most moments between two probes that are compared one by one.
  std::size_t most_frames = 2000;
  std::function<Result<bool>(std::size_t)> differs;
};

/// The first difference and how certain it is (docs/programs/golden.md, "bisect").
struct Parting {
  std::optional<std::size_t> first;  ///< first difference; empty: none found
  /// The last compared moment before `first`; equal there.
  std::optional<std::size_t> last_alike;
  /// Every moment from `searched_from` to `first` was compared or is known to be equal.
  bool is_first_since_probe = false;
  std::size_t searched_from = 0;
  std::size_t frames = 0;  ///< drawn moments
};

/// Compares the probes until one differs, then every moment since the probe before it. Ranges
/// longer than `most_frames` are bisected, which finds a change from equal to different, though
/// perhaps not the first.
Result<Parting> findParting(const PartingQuestion& question);

}  // namespace rocinante
