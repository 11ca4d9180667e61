#include "player/playhead/play_line.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>

#include "core/base/duration_text.h"
#include "core/cli/terminal.h"
#include "player/playhead/playhead.h"

namespace rocinante {
namespace {

constexpr Nanoseconds kTenth = std::chrono::milliseconds(100);
/// A longer silence shows a countdown.
constexpr Nanoseconds kLongSilence = std::chrono::seconds(2);

std::string tenths(Nanoseconds span) { return secondsText(span / kTenth * kTenth, 1); }

}  // namespace

PlayLine::PlayLine(const PlayStatus& status, LogTime origin, LogTime end, bool visible)
    : status_(status), origin_(origin), end_(end) {
  if (visible) thread_ = std::thread([this] { drawUntilStopped(); });
}

PlayLine::~PlayLine() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  stopping_.notify_all();
  thread_.join();
}

std::string PlayLine::text(const PlayStatus& status, LogTime origin, LogTime end, SteadyTime now) {
  constexpr auto kRelaxed = std::memory_order_relaxed;
  const LogTime position(Nanoseconds(status.position_ns.load(kRelaxed)));
  std::string line = fmt::format("{} of {} s, {} datagrams", tenths(position - origin),
                                 tenths(end - origin), status.sent.load(kRelaxed));
  const double speed = status.speed.load(kRelaxed);
  if (speed > 0 && speed != 1) line += fmt::format(", {}x", speed);
  const auto state = static_cast<Playhead::State>(status.state.load(kRelaxed));
  if (state == Playhead::State::paused) line += ", paused";
  if (state == Playhead::State::ended) line += ", ended";
  const std::int64_t next = status.next_ns.load(kRelaxed);
  const Nanoseconds silence = SteadyTime(Nanoseconds(next)) - now;
  if (state == Playhead::State::playing && next > 0 && silence > kLongSilence) {
    line += fmt::format(", silent for {} s more", tenths(silence));
  }
  return line;
}

void PlayLine::drawUntilStopped() {
  std::unique_lock lock(mutex_);
  while (!stopping_.wait_for(lock, std::chrono::milliseconds(200), [this] { return stop_; })) {
    const std::string line =
        cli::statusLine(text(status_, origin_, end_, std::chrono::steady_clock::now()));
    std::fwrite(line.data(), 1, line.size(), stderr);
  }
  std::fputs("\r\033[K", stderr);
}

}  // namespace rocinante
