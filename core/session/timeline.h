#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/log/log_reader.h"
#include "core/packet/session_state.h"
#include "core/result.h"
#include "core/session/keyframe_finder.h"

namespace rocinante {

/// A recorded session as a function of time: state(t) folds every folded message with
/// log_time <= t, beginning with the last usable keyframe among them (docs/log-format.md,
/// "Keyframes"). Any order of questions gives the same answers. Going on from the last one is
/// cheap, and so is going back or elsewhere: at most what lies between two keyframes is folded, and
/// states are kept along the way, in bounded memory (64 MiB). A log without keyframes is folded
/// from its start. Damage of the log is skipped, see log().damage(). Not for sharing between
/// threads.
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

  /// The state at `moment`; valid until the next call.
  Result<const SessionState*> stateAt(LogTime moment);

  /// Every event of the log, its marks among them (also those of LOG.marks, beside it), oldest
  /// first: found on the first call, which reads the log once. An error when LOG.marks is
  /// malformed.
  Result<const std::vector<Event>*> events();

  /// Keyframes met so far that do not count, and why; as they were met.
  const std::vector<KeyframeFault>& keyframeFaults() const;

  const LogReader& log() const;

 private:
  struct Impl;
  explicit Timeline(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Reads a time as a person writes it against a session: "12.5", "12.5s", "1m02.5s", "250ms" from
/// the origin, "-1s" from the end, or RFC 3339 "2026-02-03T04:05:06.789Z". Exact to the nanosecond.
Result<LogTime> parseSessionTime(std::string_view text, LogTime origin, LogTime end);

}  // namespace rocinante
