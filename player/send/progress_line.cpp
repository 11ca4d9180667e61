#include "player/send/progress_line.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>

#include "core/base/duration_text.h"
#include "core/cli/terminal.h"

namespace rocinante {

ProgressLine::ProgressLine(SendJournal& behind, LogTime origin, LogTime end, bool visible)
    : behind_(behind), origin_(origin), end_(end) {
  if (visible) thread_ = std::thread([this] { drawUntilStopped(); });
}

ProgressLine::~ProgressLine() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  stopping_.notify_all();
  thread_.join();
}

void ProgressLine::sent(const Due& due, ByteView payload, SteadyTime deadline, SteadyTime sent_at) {
  behind_.sent(due, payload, deadline, sent_at);
  if (due.restated) return;
  position_ns_.store((due.time - origin_).count(), std::memory_order_relaxed);
  sent_.fetch_add(1, std::memory_order_relaxed);
}

void ProgressLine::drawUntilStopped() {
  constexpr Nanoseconds kTenth = std::chrono::milliseconds(100);
  std::unique_lock lock(mutex_);
  while (!stopping_.wait_for(lock, std::chrono::milliseconds(200), [this] { return stop_; })) {
    const Nanoseconds position(position_ns_.load(std::memory_order_relaxed));
    const std::string line = cli::statusLine(fmt::format(
        "{} of {} s, {} datagrams", secondsText(position / kTenth * kTenth, 1),
        secondsText((end_ - origin_) / kTenth * kTenth, 1), sent_.load(std::memory_order_relaxed)));
    std::fwrite(line.data(), 1, line.size(), stderr);
  }
  std::fputs("\r\033[K", stderr);
}

}  // namespace rocinante
