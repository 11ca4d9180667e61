#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/log/log_reader.h"
#include "core/packet/session_state.h"
#include "core/session/keyframe_finder.h"
#include "core/session/message_folder.h"
#include "core/session/state_cache.h"
#include "core/session/state_damage.h"

namespace rocinante {

inline constexpr LogPosition kStartOfLog{LogTime::min(), 0};

/// The last position of the moment.
LogPosition lastAt(LogTime moment);
/// The last position before `place`.
LogPosition lastBefore(LogPosition place);

/// The fold of one log as a function of the position in it: Timeline, for a single file. Not
/// movable: its parts refer to each other. Not for sharing between threads.
class LogFold {
 public:
  explicit LogFold(LogReader reader);
  LogFold(const LogFold&) = delete;
  LogFold& operator=(const LogFold&) = delete;

  const LogReader& reader() const { return reader_; }

  /// As LogReader::refresh(). What was folded before is kept, unless new messages sort before it.
  Result<bool> refresh();

  /// The state of all messages up to and including `last`; as Timeline::stateAt().
  Result<const SessionState*> stateUpTo(LogPosition last, StateDamage* damage);
  /// As Timeline::addDamage().
  Status addDamage(LogTime from, LogTime until, StateDamage& damage);

  /// The events of the log's messages, in their order: what was read in an earlier call is not read
  /// again. Valid until the next call of any kind. `progress`, if there is one, hears which part of
  /// the log was read.
  Result<const std::vector<Event>*> events(const std::function<void(double part)>& progress);
  /// Adds the damage that may hide an event.
  void addHidingDamage(StateDamage& damage) const;

  const std::vector<KeyframeFault>& keyframeFaults() const { return finder_.faults(); }

  /// As Timeline::useStop().
  void useStop(std::stop_token stop) { stop_ = std::move(stop); }

  /// Releases the states kept to answer quickly.
  void releaseStates();

 private:
  void knowChannels();
  void startAnew();
  void startFrom(LogPosition place, SessionState from, LogPosition its_base,
                 std::uint64_t messages);
  /// The reader is moved there when it is next used.
  void goBehindReached();
  /// Starts from the nearest known position that is not behind `last`.
  Status approach(LogPosition last);
  Status reach(LogPosition last);
  /// Folds up to and including `last`, at most `most` messages: false when that was not enough.
  /// Events go to `sink`, if there is one.
  Result<bool> foldTo(LogPosition last, std::uint64_t most, std::vector<Event>* sink);
  void fold(const LogMessage& message, std::vector<Event>* sink);
  void adopt(const LogMessage& message);
  void keepState();

  LogReader reader_;
  KeyframeFinder finder_;
  MessageFolder folder_;
  std::vector<Decoder*> decoder_by_channel_;  ///< looked up once; null: not folded, or none

  // The state of the last usable keyframe before `reached_`, or the empty one, plus all messages
  // behind that up to `reached_`. Holds for any way of reaching it, even when the log contradicts
  // itself.
  SessionState state_;
  LogPosition reached_ = kStartOfLog;
  LogPosition base_ = kStartOfLog;       ///< of that keyframe
  std::uint64_t since_base_ = 0;         ///< messages read since then
  std::uint64_t since_kept_ = 0;         ///< since a state was kept
  std::optional<LogMessage> lookahead_;  ///< the first behind `reached_`, borrowed from the reader
  bool at_end_ = false;
  bool placed_ = false;  ///< the reader's next message is the first behind `reached_`

  std::stop_token stop_;
  StateCache cache_;
  std::vector<Event> events_;
  bool events_found_ = false;               ///< and nothing was appended since
  LogPosition events_until_ = kStartOfLog;  ///< of the last message read for them
};

}  // namespace rocinante
