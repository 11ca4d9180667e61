#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/log/log_reader.h"
#include "core/packet/session_state.h"
#include "core/session/keyframe.h"
#include "core/session/session_time.h"
#include "core/session/state_damage.h"

namespace rocinante {

/// A recorded session as a function of time: state(t) folds every folded message with
/// log_time <= t, beginning with the last usable keyframe among them (docs/log-format.md,
/// "Keyframes"). Any order of questions gives the same answers. Going on from the last one is
/// cheap, and so is going back or elsewhere: at most what lies between two keyframes is folded, and
/// states are kept along the way, in bounded memory (64 MiB). A log without keyframes is folded
/// from its start. Not for sharing between threads.
///
/// Damage. What cannot be read is skipped, and the state is as old as what was read before it until
/// the next keyframe, which knows what was lost. So a state is *damaged* when messages may be
/// missing behind the keyframe that it begins with (the log's start where there is none) and not
/// later than its moment; LogReader::unreadable() says where they lie. That is a property of log
/// and moment, and the same alone, in order and shuffled: whatever way a state was reached, all
/// that lies between its keyframe and its moment was read once, and what is known of elsewhere does
/// not count. In particular
/// - a chunk that fails its checksum costs the times that its index gives, and so does one of which
///   a message is malformed or on an unknown channel: nobody knows which time those had;
/// - bytes that are no record, and a chunk that is gone with its index, cost what lies between the
///   chunks beside them;
/// - a keyframe that is broken is none: the span that must be whole then begins at the one before;
/// - a log that was cut, or whose recorder was killed, has all moments up to its last message, and
///   none behind it; one without a message that can be read has none at all;
/// - damage that cost no message (of the summary, of a message index) is none of a state, and
///   neither is what the recorder could not take down (LogReader::losses).
/// Nobody gets a damaged state unawares: it is an error, of kind `damaged`, unless the caller takes
/// the damage too.
class Timeline {
 public:
  static Result<Timeline> open(const std::filesystem::path& path);
  /// The same of a log that is open already.
  static Timeline of(LogReader reader);

  ~Timeline();
  Timeline(Timeline&&) noexcept;
  Timeline& operator=(Timeline&&) noexcept;

  LogTime origin() const;
  LogTime start() const;
  LogTime end() const;

  /// The state at `moment`; valid until the next call. Where it is damaged: an error, or with
  /// `damage` what can be known, and what it may lack is added there.
  Result<const SessionState*> stateAt(LogTime moment, StateDamage* damage = nullptr);
  /// Adds the damage of every state from `from` to `until`: reads what lies between them.
  Status addDamage(LogTime from, LogTime until, StateDamage& damage);

  /// Every event of the log, its marks among them (also those of LOG.marks, beside it), oldest
  /// first: found on the first call, which reads the log once. An error when LOG.marks is
  /// malformed, and, where damage may hide one, as stateAt() has it.
  Result<const std::vector<Event>*> events(StateDamage* damage = nullptr);

  /// Keyframes met so far that do not count, and why; as they were met.
  const std::vector<KeyframeFault>& keyframeFaults() const;

  const LogReader& log() const;

 private:
  struct Impl;
  explicit Timeline(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace rocinante
