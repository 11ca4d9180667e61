#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "core/base/result.h"
#include "core/packet/packet.h"
#include "core/session/message_folder.h"
#include "core/session/timeline.h"

namespace rocinante {

/// Receives a session in order of time; an error ends the walk. Either may be empty.
struct MomentVisitor {
  /// Each folded message (LogChannel::folded) and its packet, null if it holds none; both are
  /// borrowed for the call. A packet may also come late, and change nothing.
  std::function<Status(const LogMessage&, const Packet*)> message;
  /// After the last folded message of each log time: the state then, borrowed for the call.
  std::function<Status(LogTime, const SessionState&)> moment;
};

/// Visits the moments of a log at which anything was said: the state is Timeline's, so it begins
/// with what a keyframe says, and is right again with the next one after damage. One pass over the
/// file for each call, in bounded memory. Not for sharing between threads.
class MomentWalk {
 public:
  static Result<MomentWalk> open(const std::filesystem::path& path);

  /// Visits the moments in [from, until). Damage is skipped, and listed by damage().
  Status visit(LogTime from, LogTime until, const MomentVisitor& visitor);

  /// The state of any moment, as Timeline::stateAt(); damage is listed by damage().
  Result<const SessionState*> stateAt(LogTime moment);

  /// Every event of the log and its marks, as Timeline::events(); reads the log once.
  Result<const std::vector<Event>*> events();

  const LogReader& log() const { return reader_; }
  /// What of the log could not be read so far, and the keyframes that were ignored: sentences with
  /// their places, in the order of the file. Empty: everything visited was whole.
  std::vector<std::string> damage() const;

 private:
  MomentWalk(LogReader reader, Timeline timeline)
      : reader_(std::move(reader)), timeline_(std::move(timeline)) {}

  LogReader reader_;
  Timeline timeline_;
  MessageFolder folder_;
};

}  // namespace rocinante
