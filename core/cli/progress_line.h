#pragma once

#include <chrono>
#include <string>

#include "core/cli/status_line.h"

namespace rocinante::cli {

/// "reading session.mcap 42 %" on a terminal, once the work has taken a second; nothing elsewhere.
class ProgressLine {
 public:
  /// `doing` is the text before the percentage.
  explicit ProgressLine(std::string doing);

  /// `part`: how much of the work is done, 0 to 1.
  void show(double part);
  /// Removes the line until the next show().
  void clear() { line_.clear(); }

 private:
  std::string doing_;
  StatusLine line_;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace rocinante::cli
