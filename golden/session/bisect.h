#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/session/timeline.h"
#include "golden/session/first_parting.h"

namespace rocinante {

/// One of two things that are drawn at the same moments: the pixel hash at a time from the log's
/// origin. An error for a moment that cannot be drawn.
using DrawnHash = std::function<Result<std::string>(Nanoseconds since_origin)>;

struct BisectQuestion {
  DrawnHash a, b;
  /// Each moment from the origin at which the state of either changes, in order; see changesOf().
  std::vector<Nanoseconds> moments;
  std::vector<Nanoseconds> probes;  ///< events and keyframes
  Nanoseconds alike_before{0};      ///< known without drawing
  std::size_t most_frames = 2000;
};

struct BisectAnswer {
  std::optional<Nanoseconds> first;       ///< the pictures differ there; empty: nowhere
  std::optional<Nanoseconds> last_alike;  ///< the state change before it, where they do not
  bool is_first_since_probe = false;
  Nanoseconds searched_from{0};
  std::size_t frames = 0;  ///< moments drawn, of
  std::size_t moments = 0;
};

/// The first moment at which both draw different pictures, as findParting() looks for it.
Result<BisectAnswer> bisectPictures(const BisectQuestion& question);

/// Times from the origin of every message that the fold reads: between two of them nothing changes.
Result<std::vector<Nanoseconds>> changesOf(const std::filesystem::path& log);
/// The first time from the origin at which the states of two logs are not the same, but for when
/// and by whom things were said; empty when they never part.
Result<std::optional<Nanoseconds>> statesPart(Timeline& a, Timeline& b,
                                              const std::vector<Nanoseconds>& moments);

}  // namespace rocinante
