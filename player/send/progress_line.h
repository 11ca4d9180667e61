#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "player/send/paced_sender.h"

namespace rocinante {

/// A terminal line with the position of sending, five times a second, from its own thread: a slow
/// terminal must not delay a deadline. Forwards everything to the journal behind it.
class ProgressLine final : public SendJournal {
 public:
  /// Seconds are shown from `origin`. Draws only when `visible`, on stderr.
  ProgressLine(SendJournal& behind, LogTime origin, LogTime end, bool visible);
  /// Clears the line.
  ~ProgressLine() override;

  void sent(const Due& due, ByteView payload, SteadyTime deadline, SteadyTime sent_at) override;

 private:
  void drawUntilStopped();

  SendJournal& behind_;
  LogTime origin_, end_;
  std::atomic<std::int64_t> position_ns_{0};
  std::atomic<std::uint64_t> sent_{0};
  std::mutex mutex_;
  std::condition_variable stopping_;
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace rocinante
