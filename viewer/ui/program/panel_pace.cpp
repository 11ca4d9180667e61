#include "viewer/ui/program/panel_pace.h"

#include <chrono>

namespace rocinante {

Nanoseconds panelsChangeEvery(const ViewModel& model, const ProgramBusy& busy, SteadyTime now) {
  using namespace std::chrono_literals;
  // One frame after the other.
  if (model.viewer.fly.moving()) return Nanoseconds(0);
  if (model.viewer.packet.searching()) return 16ms;
  if (busy.loading) return 50ms;
  if (busy.notice || busy.typing) return 200ms;
  const std::optional<Nanoseconds> silent = model.liveSilence(now);
  return silent ? agesChangeEvery(*silent) : Nanoseconds::max();
}

double newsWait(const ViewModel& model) {
  const TimelineCursor* const cursor = model.cursor();
  const bool goes_on = cursor != nullptr && cursor->following();
  // A live feed wakes the window (LiveFeed::onNews).
  const bool is_busy =
      (goes_on && !model.isLive()) || model.isStudyBusy() || model.hand.driving() != nullptr;
  return is_busy ? 0.016 : 0.1;
}

}  // namespace rocinante
