#include "player/send/live_line.h"

#include <chrono>
#include <utility>

#include "core/cli/status_line.h"

namespace rocinante {

LiveLine::LiveLine(std::function<std::string()> text, bool visible) : text_(std::move(text)) {
  if (visible) thread_ = std::thread([this] { drawUntilStopped(); });
}

LiveLine::~LiveLine() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  stopping_.notify_all();
  thread_.join();
}

void LiveLine::drawUntilStopped() {
  cli::StatusLine line;
  std::unique_lock lock(mutex_);
  while (!stopping_.wait_for(lock, std::chrono::milliseconds(200), [this] { return stop_; })) {
    line.show(text_());
  }
}

}  // namespace rocinante
