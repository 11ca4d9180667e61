#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "player/send/paced_sender.h"

namespace rocinante {

/// A line on a terminal that says where sending is, five times a second, from a thread of its own:
/// a slow terminal must not delay a deadline. Passes everything on to the journal behind it.
class ProgressLine final : public SendJournal {
 public:
  /// `origin` is what the shown seconds count from. Draws only when `visible`, on stderr.
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
