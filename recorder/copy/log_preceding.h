#pragma once

#include "core/log/log_reader.h"
#include "recorder/copy/copy_source.h"
#include "recorder/copy/log_selection.h"

namespace rocinante {

/// Folds the wanted messages of a log one after another: what a copy of them makes of the session.
class SelectionFold {
 public:
  SelectionFold(Selection& selection, SessionState state)
      : selection_(selection), state_(std::move(state)) {}

  /// Folds the message if it is wanted, folded, and a decoder knows it.
  void fold(const LogMessage& message);

  const SessionState& state() const { return state_; }
  SessionState takeState() { return std::move(state_); }

 private:
  Selection& selection_;
  SessionState state_;
  PacketTextDecoder decoder_;
};

/// The keyframe that a log begins with, before anything that is folded: it tells what no message of
/// this log does. Empty when there is none, or when it cannot be read (then `fault` says why).
/// Borrowed until the reader is asked for the next. Moves the reader.
Result<std::optional<LogMessage>> openingKeyframe(LogReader& reader, std::string& fault);

/// The state that a keyframe tells of what is wanted, its log times moved by `shift`. The payload
/// must be one that KeyframeReader takes.
SessionState wantedKeyframeState(ByteView payload, LogTime moment, const Selection& selection,
                                 Nanoseconds shift);

/// What precedes `from` in the log, when its wanted messages alone are folded, beginning with
/// `opening` (what its opening keyframe tells of them). Reads the log from its start.
Result<Preceding> precedingBySelection(LogReader& reader, Selection& selection,
                                       const SessionState& opening, LogTime from,
                                       const CopyProgress& progress);

/// The same when every message is wanted: found by the keyframes, so the cost does not grow with
/// the log. Opens the file for itself.
Result<Preceding> precedingOf(const std::filesystem::path& path, LogTime from);

}  // namespace rocinante
