#include "core/cli/progress_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

#include "core/cli/program.h"
#include "core/cli/terminal.h"

namespace rocinante::cli {

using Clock = std::chrono::steady_clock;

ProgressLine::ProgressLine(std::string doing)
    : doing_(std::move(doing)),
      on_(::isatty(STDERR_FILENO) == 1),
      next_(Clock::now() + std::chrono::seconds(1)) {}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::clear() {
  if (shown_) std::fputs("\r\033[K", stderr);
  shown_ = false;
}

void ProgressLine::show(double part) {
  if (!on_ || Clock::now() < next_) return;
  next_ = Clock::now() + std::chrono::milliseconds(100);
  shown_ = true;
  tell(statusLine(fmt::format("{} {:3.0f} %", doing_, part * 100)));
}

}  // namespace rocinante::cli
