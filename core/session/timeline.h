#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/parallel_for.h"
#include "core/base/result.h"
#include "core/log/log_reader.h"
#include "core/packet/session_state.h"
#include "core/session/keyframe.h"
#include "core/session/session_time.h"
#include "core/session/state_damage.h"

namespace rocinante {

/// A recorded session as a function of time: state(t) folds every folded message with log_time <=
/// t, beginning with the last usable keyframe among them (docs/log-format.md, "Keyframes"). Results
/// do not depend on the order of queries. Continuing from the last query is cheap, and so is moving
/// back or elsewhere: at most the messages between two keyframes are folded, and states are kept
/// along the way, in bounded memory (64 MiB). A log without keyframes is folded from its start. Not
/// for sharing between threads.
///
/// Damage. Unreadable messages are skipped, and the state stays as old as the last readable one
/// until the next keyframe, which includes what was lost. So a state is *damaged* when messages may
/// be missing after the keyframe that it begins with (or the log's start) and not later than its
/// moment; LogReader::unreadable() says where they were. That is a property of log and moment, the
/// same for single, ordered and shuffled queries: everything between a state's keyframe and its
/// moment was read once, and damage known elsewhere is ignored. In particular
/// - a chunk that fails its checksum costs the times in its index, and so does one with a malformed
///   message or one on an unknown channel, because the time of that message is unknown;
/// - bytes that are not a record, and a chunk that is lost with its index, cost the range between
///   the neighbouring chunks;
/// - a broken keyframe is not used: the span that must be whole then begins at the one before;
/// - a log that was cut, or whose recorder was killed, has all moments up to its last message, and
///   none after it; a log without a readable message has none at all;
/// - damage that cost no message (of the summary, of a message index) does not damage a state, and
///   neither do datagrams that the recorder could not keep (LogReader::losses).
/// A damaged state is never returned silently: it is an error, of kind `damaged`, unless the caller
/// accepts the damage too.
class Timeline {
 public:
  static Result<Timeline> open(const std::filesystem::path& path);
  /// The same for a log that may still be written. refresh() reads what was appended, and continues
  /// with the next piece of a recording in pieces (`record --split-time`), which it finds in the
  /// same folder by its session's id. Pieces that their recorder deletes drop out: start() then
  /// moves. Each later piece opens with the state before it, so every moment is found in one piece.
  static Result<Timeline> follow(const std::filesystem::path& path);
  /// The same for a log that is already open.
  static Timeline of(LogReader reader);

  ~Timeline();
  Timeline(Timeline&&) noexcept;
  Timeline& operator=(Timeline&&) noexcept;

  /// From now on a query that folds ends soon after `stop` is requested, as refused. For a thread
  /// that someone may wait for.
  void useStop(std::stop_token stop);

  LogTime origin() const;
  LogTime start() const;
  LogTime end() const;

  /// Looks for what was written since the last call; true when there is something. Every state,
  /// event and message borrowed before is invalid then. States of moments before the old end() are
  /// as they were, unless messages came out of time order. An error when the log was truncated, or
  /// a next piece cannot be read; what was read before can still be asked for.
  Result<bool> refresh();
  /// More may come: a program is writing the log, or has begun another piece. For follow().
  bool growing() const;

  /// The state at `moment`; valid until the next call. If it is damaged: an error, or with `damage`
  /// the state as far as known, and the parts it may lack are added there.
  Result<const SessionState*> stateAt(LogTime moment, StateDamage* damage = nullptr);
  /// The same for the fold of all messages before `place`, which may be inside a moment.
  Result<const SessionState*> stateBefore(LogPosition place, StateDamage* damage = nullptr);
  /// Adds the damage of every state from `from` to `until`: reads the log between them.
  Status addDamage(LogTime from, LogTime until, StateDamage& damage);

  /// Every event of the log, including its marks (also those of LOG.marks, beside it), oldest
  /// first: found on the first call, which reads the log once, and after refresh() what is new. An
  /// error when LOG.marks is malformed, or, as for stateAt(), when damage may hide an event.
  /// `progress` hears how far the reading is, in the calling thread.
  Result<const std::vector<Event>*> events(StateDamage* damage = nullptr,
                                           const TellLoadProgress& progress = {});

  /// Unusable keyframes met so far, in that order, and why.
  const std::vector<KeyframeFault>& keyframeFaults() const;

  /// The log; of several pieces, the last.
  const LogReader& log() const;
  /// The piece that has the moment.
  const LogReader& logAt(LogTime moment) const;

 private:
  struct Impl;
  explicit Timeline(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace rocinante
