#pragma once

#include <chrono>
#include <string>

namespace rocinante::cli {

/// "reading session.mcap 42 %" on a terminal, once the work has taken a second; nothing elsewhere.
class ProgressLine {
 public:
  /// `doing` is what stands before the percentage.
  explicit ProgressLine(std::string doing);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// `part` of the work is done, 0 to 1.
  void show(double part);
  /// Takes it away again, until the next show().
  void clear();

 private:
  std::string doing_;
  bool on_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace rocinante::cli
