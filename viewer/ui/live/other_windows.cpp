#include "viewer/ui/live/other_windows.h"

#include <utility>

namespace rocinante {

bool OtherWindows::look(const SessionState& state, std::span<const LiveSource> sources,
                        SteadyTime now) {
  const auto before = std::exchange(silent_, {});
  left_.clear();
  for (const LiveSource& source : sources) {
    if (state.views().contains(source.name)) {
      known_.insert(source.name);
      if (now - source.heard >= kSilence) silent_.insert(source.name);
    } else if (known_.contains(source.name)) {
      left_.insert(source.name);
    }
  }
  return silent_ != before;
}

}  // namespace rocinante
