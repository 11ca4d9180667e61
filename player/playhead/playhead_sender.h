#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/signing/signed_datagram.h"
#include "player/playhead/play_line_text.h"
#include "player/playhead/playhead.h"
#include "player/send/paced_sender.h"

namespace rocinante {

/// The source of a running player's commands: another thread, which waits for each answer before it
/// hands over the next line, so that a flood of commands cannot delay a deadline for long.
class CommandSource {
 public:
  virtual ~CommandSource() = default;

  /// The line waiting for an answer; the same until answer().
  virtual std::optional<std::string_view> asked() = 0;
  /// Answers the line; empty for no answer.
  virtual void answer(std::string line) = 0;
  /// Sends an unrequested line to the controlling client.
  virtual void tell(std::string line) = 0;
};

struct PlayheadRules {
  bool stays = false;  ///< wait for commands at the end
  LogTime origin{}, end{};
  Nanoseconds ack_timeout = std::chrono::seconds(1);
  DatagramSigner* signer = nullptr;  ///< if set, signs the player's own restatements
  /// Gets a line about each silence of more than a minute; may be empty.
  std::function<void(std::string_view line)> notify = {};
};

/// Sends what the playhead says when it says so, and passes it the commands. Nothing is sent early,
/// dropped or reordered. `commands` may be null. Returns at the end, or on a stop or a quit command
/// (stopped); fails when the logs or the network fail, or no `ack` comes in time.
Result<SendEnd> sendPlayhead(Playhead& playhead, const PlayheadRules& rules, SendPort& port,
                             SendJournal& journal, CommandSource* commands, PlayStatus& status);

}  // namespace rocinante
