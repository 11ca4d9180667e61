#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "core/cell/cell.h"
#include "core/check/watch/finding_watch.h"

namespace rocinante {

/// A standing watch over what is being recorded (FindingWatch), which triggers a ring when a
/// finding begins.
///
/// Live, it judges on a thread of its own: datagrams are copied into a bounded queue, and the
/// writing thread never waits. Datagrams for which there is no room are not judged, and counted;
/// what they would have said is missing in the judgement (it may then find gaps). Of a file, whose
/// datagrams come as fast as they are written, it judges on the writing thread, all of them.
///
/// Used by the writing thread alone.
class FindingTrigger {
 public:
  static constexpr std::size_t kMaxQueuedBytes = std::size_t{16} << 20U;

  /// A finding that began.
  struct Begun {
    LogTime at{};
    std::string text;  ///< "SENTENCE [RULE]"
  };

  /// Begins of findings at least as severe as `severity` trigger. `is_live`: on a thread of its
  /// own.
  FindingTrigger(Cell cell, Severity severity, bool is_live);
  ~FindingTrigger();
  FindingTrigger(const FindingTrigger&) = delete;
  FindingTrigger& operator=(const FindingTrigger&) = delete;

  /// The next datagram in time order, as SessionCheck takes it; copied.
  void add(LogTime time, std::string_view encoding, bool captured, ByteView datagram);
  /// A datagram that is not packet text, by the packet that a decoder made of it; copied.
  void addMade(LogTime time, std::string_view encoding, ByteView made);
  void addLoss(const LossSpan& span);
  /// Everything before this moment was added.
  void reach(LogTime moment);

  /// Findings that began since the last call.
  std::vector<Begun> take();
  /// Datagrams that were not judged.
  std::uint64_t dropped() const { return dropped_; }
  /// Judges what is queued and ends the thread. take() still gives what it found; nothing may be
  /// added any more.
  void finish();

 private:
  struct Queued {
    LogTime time{};
    std::string encoding;
    bool captured = false;
    bool made = false;      ///< the payload is what a decoder made
    std::size_t bytes = 0;  ///< of the payload, in the queue's order
  };
  /// Datagrams in order, their payloads one after another.
  struct Queue {
    std::vector<Queued> items;
    std::vector<std::byte> payloads;
    std::vector<LossSpan> losses;
    std::optional<LogTime> reached;
    bool isEmpty() const { return items.empty() && losses.empty() && !reached; }
    void clear();
  };

  /// Queues an item, or judges it at once.
  void add(Queued item, ByteView payload);
  void work();
  void judge(const Queue& queue);
  void judge(const Queued& item, ByteView payload);
  void passTo(LogTime now);

  const Cell cell_;
  FindingWatch watch_;  ///< the thread's, when there is one
  std::optional<LogTime> passed_;
  const bool is_live_;
  std::uint64_t dropped_ = 0;
  std::optional<LogTime> reached_;  ///< last told to the thread

  std::mutex mutex_;
  std::condition_variable given_;
  Queue queue_;  ///< guarded by mutex_, as are the next two
  std::vector<Begun> begun_;
  bool is_finished_ = false;
  std::thread thread_;  ///< last: it uses the members above
};

}  // namespace rocinante
