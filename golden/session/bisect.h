#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/session/timeline.h"

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

/// Draws one side at a time from the log's origin and returns the pixel hash. An error for a moment
/// that cannot be drawn.
using DrawnHash = std::function<Result<std::string>(Nanoseconds since_origin)>;

struct BisectQuestion {
  DrawnHash a, b;
  /// Times from the origin at which either state changes, in order; see changesOf().
  std::vector<Nanoseconds> moments;
  std::vector<Nanoseconds> probes;  ///< events and keyframes
  Nanoseconds alike_before{0};      ///< known to be equal before it, without drawing
  std::size_t most_frames = 2000;
};

struct BisectAnswer {
  std::optional<Nanoseconds> first;       ///< the first different pictures; empty: none
  std::optional<Nanoseconds> last_alike;  ///< the last equal pictures before it
  bool is_first_since_probe = false;
  Nanoseconds searched_from{0};
  std::size_t frames = 0;  ///< moments drawn, of
  std::size_t moments = 0;
};

/// Finds the first moment at which both sides draw different pictures, by findParting().
Result<BisectAnswer> bisectPictures(const BisectQuestion& question);

/// Times from the origin of every message that the fold reads; the state is constant between them.
Result<std::vector<Nanoseconds>> changesOf(const std::filesystem::path& log);
/// The first time from the origin at which the states of two logs differ, ignoring times and
/// sources of packets; empty when they never differ.
Result<std::optional<Nanoseconds>> statesPart(Timeline& a, Timeline& b,
                                              const std::vector<Nanoseconds>& moments);

}  // namespace rocinante
