#pragma once

#include <set>
#include <span>
#include <string>
#include <string_view>

#include "core/base/time.h"
#include "viewer/ui/live/source_watch.h"

namespace rocinante {

/// The windows of others in a live session, known by a view of their own name (`--publish`). One
/// that closes takes back what it said; one that was killed falls silent, although windows restate
/// what they say every two seconds. A plain value.
class OtherWindows {
 public:
  /// Three restatements are missing.
  static constexpr Nanoseconds kSilence = std::chrono::seconds(6);

  /// Takes the sources as heard up to `now`, on the clock of LiveSource::heard. True when another
  /// one is silent, or one that was speaks again.
  bool look(const SessionState& state, std::span<const LiveSource> sources, SteadyTime now);

  /// Whether this window is there but says nothing any more.
  bool isSilent(std::string_view name) const { return silent_.contains(name); }
  /// Whether this source was a window, which has closed.
  bool hasLeft(std::string_view name) const { return left_.contains(name); }

 private:
  std::set<std::string, std::less<>> known_, silent_, left_;
};

}  // namespace rocinante
