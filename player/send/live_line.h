#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace rocinante {

/// A terminal line on stderr that is drawn five times a second from its own thread: a slow terminal
/// must not delay a deadline.
class LiveLine {
 public:
  /// `text` gives the line; called in the other thread while this lives. Draws only when `visible`.
  LiveLine(std::function<std::string()> text, bool visible);
  /// Clears the line.
  ~LiveLine();
  LiveLine(const LiveLine&) = delete;
  LiveLine& operator=(const LiveLine&) = delete;

 private:
  void drawUntilStopped();

  std::function<std::string()> text_;
  std::mutex mutex_;
  std::condition_variable stopping_;
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace rocinante
