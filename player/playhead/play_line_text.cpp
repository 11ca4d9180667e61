#include "player/playhead/play_line_text.h"

#include <fmt/format.h>

#include "core/base/duration_text.h"
#include "player/playhead/playhead.h"
#include "player/send/send_progress.h"

namespace rocinante {
namespace {

constexpr Nanoseconds kTenth = std::chrono::milliseconds(100);
/// A longer silence shows a countdown.
constexpr Nanoseconds kLongSilence = std::chrono::seconds(2);

}  // namespace

std::string playLineText(const PlayStatus& status, LogTime origin, LogTime end, SteadyTime now) {
  constexpr auto kRelaxed = std::memory_order_relaxed;
  const LogTime position(Nanoseconds(status.position_ns.load(kRelaxed)));
  std::string line = progressText(position, origin, end, status.sent.load(kRelaxed));
  const double speed = status.speed.load(kRelaxed);
  if (speed > 0 && speed != 1) line += fmt::format(", {}x", speed);
  const auto state = static_cast<Playhead::State>(status.state.load(kRelaxed));
  if (state == Playhead::State::paused) line += ", paused";
  if (state == Playhead::State::ended) line += ", ended";
  const std::int64_t next = status.next_ns.load(kRelaxed);
  const Nanoseconds silence = SteadyTime(Nanoseconds(next)) - now;
  if (state == Playhead::State::playing && next > 0 && silence > kLongSilence) {
    line += fmt::format(", silent for {} s more", secondsText(silence / kTenth * kTenth, 1));
  }
  return line;
}

}  // namespace rocinante
