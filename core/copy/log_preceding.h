#pragma once

#include "core/copy/copy_source.h"
#include "core/copy/log_selection.h"
#include "core/log/log_reader.h"
#include "core/session/message_folder.h"

namespace rocinante {

/// Folds the wanted messages of a log, as a reader of the copy would.
class SelectionFold {
 public:
  SelectionFold(Selection& selection, SessionState state)
      : selection_(selection), state_(std::move(state)) {}

  /// Folds the message if it is wanted, its channel is folded, and it can be decoded.
  void fold(const LogMessage& message);

  const SessionState& state() const { return state_; }
  SessionState takeState() { return std::move(state_); }

 private:
  Selection& selection_;
  SessionState state_;
  MessageFolder folder_;
};

/// The opening keyframe of a log, before any folded message: it states what no message of this log
/// does. Empty when there is none or it cannot be read (then `fault` says why). Borrowed until the
/// reader's next call. Moves the reader.
Result<std::optional<LogMessage>> openingKeyframe(LogReader& reader, std::string& fault);

/// The wanted part of a keyframe's state, its log times moved by `shift`. KeyframeReader must
/// accept the payload.
SessionState wantedKeyframeState(ByteView payload, LogTime moment, const Selection& selection,
                                 Nanoseconds shift);

/// The state before `from` when only wanted messages are folded, starting from `opening` (the
/// wanted part of the log's opening keyframe). Reads the log from its start.
Result<Preceding> precedingBySelection(LogReader& reader, Selection& selection,
                                       const SessionState& opening, LogTime from,
                                       const CopyProgress& progress);

/// The same when every message is wanted: uses keyframes, so the cost does not grow with the log.
/// Opens the file itself.
Result<Preceding> precedingOf(const std::filesystem::path& path, LogTime from);

}  // namespace rocinante
