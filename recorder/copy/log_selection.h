#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/log/log_reader.h"
#include "core/packet/packet_text.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// What of a log is wanted, as a person says it (docs/programs/log.md, "Choosing messages").
/// Patterns are a shell's. Several of one kind: any of them; of different kinds: all of them.
struct SelectionOptions {
  std::string from;        ///< a session time; empty: the start
  std::string until;       ///< not included; empty: with the last message
  std::string from_event;  ///< pattern of an event's text, in place of `from`
  std::string until_event;
  std::vector<std::string> channels;      ///< topics to keep
  std::vector<std::string> not_channels;  ///< topics to drop
  std::vector<std::string> sources;       ///< SOURCEs to keep
  std::vector<std::string> devices;       ///< datagrams that say something about such a device
  std::vector<std::string> encodings;     ///< "rk1", "octets"

  bool anyChoice() const {
    return !channels.empty() || !not_channels.empty() || !sources.empty() || !devices.empty() ||
           !encodings.empty();
  }
  bool anyTime() const {
    return !from.empty() || !until.empty() || !from_event.empty() || !until_event.empty();
  }
};

/// The times [from, until) of a session that are wanted.
struct TimeRange {
  LogTime from{Nanoseconds(std::numeric_limits<std::int64_t>::min())};
  LogTime until{Nanoseconds(std::numeric_limits<std::int64_t>::max())};

  bool opened() const { return from != TimeRange{}.from; }
  bool ended() const { return until != TimeRange{}.until; }
  bool holds(LogTime time) const { return time >= from && time < until; }
};

/// The range that the options name in a log; `events` are the log's, oldest first, and are looked
/// at only when an event is asked for. bad_argument when a time cannot be read or nothing lies
/// between the two; not_found when no event matches.
Result<TimeRange> rangeOf(const SelectionOptions& options, const LogSummary& summary,
                          const std::vector<Event>& events);

/// Which messages of one log are wanted, whatever their time. A datagram is wanted whole or not at
/// all. Of the recorder's own channels, those that tell of losses, clock steps and marks are always
/// wanted unless `not_channels` names them; a restated datagram is taken as its channel without
/// /rocinante/restated would be. Holds a decoder: one a thread.
class Selection {
 public:
  /// Everything.
  Selection() = default;
  /// The channels are the log's; they are looked at now.
  Selection(const SelectionOptions& options, const std::vector<LogChannel>& channels);

  bool wants(const LogMessage& message);
  /// The same of a datagram that stands in a keyframe, and so on no channel.
  bool wantsRestated(const Packet& packet) const;
  /// True when no message that is folded can be left out.
  bool wantsAll() const { return wants_all_; }

 private:
  enum class Answer : std::uint8_t { no, yes, by_packet, by_restated };

  Answer answerFor(const LogChannel& channel, const SelectionOptions& options) const;
  bool wantsPacket(const Packet& packet) const;

  bool wants_all_ = true;
  std::vector<Answer> by_channel_;         ///< by channel id
  std::vector<std::string> sources_;       ///< patterns; empty: any
  std::vector<std::string> devices_;       ///< patterns; empty: any
  std::vector<std::string> gone_sources_;  ///< sorted: only channels that are not wanted are theirs
  std::unique_ptr<PacketTextDecoder> decoder_;  ///< null when everything is wanted
};

}  // namespace rocinante
