#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <string_view>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/time.h"
#include "core/packet/session_state.h"
#include "player/logs/play_routes.h"
#include "player/logs/restated_block.h"

namespace rocinante {

/// The restatements that a player sends beside the messages of its logs: after a jump, and again
/// and again in silences. It holds the datagrams of one, and says when the next is due. Those that
/// stand between messages in quick succession belong to the run (TapeStream), which reports them
/// by postpone(). It reads no clock. One thread.
class RestatementSchedule {
 public:
  /// Borrows `routes`. `repeat` is real time from one to the next; 0: none is repeated. A datagram
  /// has at most `datagram_bytes`, as restatedBlock() says.
  RestatementSchedule(const PlayRoutes& routes, Nanoseconds repeat, std::size_t datagram_bytes)
      : routes_(&routes), repeat_(repeat), datagram_bytes_(datagram_bytes) {}

  /// Begins one of `state`, and forgets what was left of the one before.
  void begin(const SessionState& state, const std::set<std::string>& sources,
             std::string_view part_id, SteadyTime now);
  /// Forgets what was left; the next is due after a whole `repeat`.
  void clear(SteadyTime now);
  /// Everything was restated at `now`, here or by the run.
  void postpone(SteadyTime now) { due_at_ = now + repeat_; }
  /// What is left was to be sent from `now` on, not earlier.
  void restamp(SteadyTime now) { asked_at_ = now; }

  /// The next one is to begin.
  bool isDue(SteadyTime now) const { return now >= dueAt(); }
  SteadyTime dueAt() const { return repeat_.count() > 0 ? due_at_ : SteadyTime::max(); }
  /// Datagrams are left.
  bool isSending() const { return taken_ < block_.size(); }
  SteadyTime askedAt() const { return asked_at_; }              ///< since when they are due
  std::uint16_t route() const { return block_[taken_].route; }  ///< of the next; while isSending()
  /// The next one, which is then sent; valid until begin() or clear(). While isSending().
  ByteView take(SteadyTime now);

 private:
  const PlayRoutes* routes_;
  Nanoseconds repeat_;
  std::size_t datagram_bytes_;
  std::vector<RestatedDatagram> block_;
  std::size_t taken_ = 0;
  SteadyTime asked_at_{}, due_at_{};
};

}  // namespace rocinante
