#include "core/cli/progress_line.h"

#include <fmt/format.h>

#include <utility>

namespace rocinante::cli {

using Clock = std::chrono::steady_clock;

ProgressLine::ProgressLine(std::string doing)
    : doing_(std::move(doing)), next_(Clock::now() + std::chrono::seconds(1)) {}

void ProgressLine::show(double part) {
  if (!line_.isVisible() || Clock::now() < next_) return;
  next_ = Clock::now() + std::chrono::milliseconds(100);
  line_.show(fmt::format("{} {:3.0f} %", doing_, part * 100));
}

}  // namespace rocinante::cli
