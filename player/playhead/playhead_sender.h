#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "player/playhead/play_status.h"
#include "player/playhead/playhead.h"
#include "player/send/paced_sender.h"

namespace rocinante {

/// Where a running player's commands come from: another thread, which waits for the answer of one
/// line before it hands over the next, so that no flood of them delays a deadline for long.
class CommandSource {
 public:
  virtual ~CommandSource() = default;

  /// A line that waits for its answer; the same until it is answered.
  virtual std::optional<std::string_view> asked() = 0;
  /// Answers it. Empty: nothing is to be said.
  virtual void answer(std::string line) = 0;
  /// Says something unasked to whoever controls.
  virtual void tell(std::string line) = 0;
};

struct PlayheadRules {
  bool stays = false;  ///< at the end it waits for commands
  LogTime origin{}, end{};
  Nanoseconds ack_timeout = std::chrono::seconds(1);
};

/// Sends what the transport says when it says so, and hands it the commands. Nothing early, nothing
/// dropped, nothing out of order. `commands` may be null. Returns at the end, when told to stop or
/// to quit (stopped); fails when the logs or the network do, or no `ack` came in time.
Result<SendEnd> sendPlayhead(Playhead& playhead, const PlayheadRules& rules, SendPort& edge,
                             SendJournal& journal, CommandSource* commands, PlayStatus& status);

}  // namespace rocinante
