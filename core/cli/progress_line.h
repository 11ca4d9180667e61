#pragma once

#include <chrono>
#include <string>

namespace rocinante::cli {

/// "reading session.mcap 42 %" on a terminal, once the work has taken a second; nothing elsewhere.
class ProgressLine {
 public:
  /// `doing` is the text before the percentage.
  explicit ProgressLine(std::string doing);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// `part`: how much of the work is done, 0 to 1.
  void show(double part);
  /// Removes the line until the next show().
  void clear();

 private:
  std::string doing_;
  bool on_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace rocinante::cli
