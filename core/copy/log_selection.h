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

/// The user's choice of messages (docs/programs/log.md, "Choosing messages"), as patterns.
/// Several of one kind: any of them; different kinds: all of them.
struct SelectionOptions {
  std::string from;        ///< a session time; empty: the start
  std::string until;       ///< not included; empty: with the last message
  std::string from_event;  ///< pattern of an event's text, instead of `from`
  std::string until_event;
  std::vector<std::string> channels;      ///< topics to keep
  std::vector<std::string> not_channels;  ///< topics to drop
  std::vector<std::string> sources;       ///< SOURCEs to keep
  std::vector<std::string> devices;       ///< keep datagrams with statements about such a device
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

/// The range that the options name in a log; `events` are the log's, oldest first, and used only
/// when the options name an event. bad_argument when a time cannot be read or the range is empty;
/// not_found when no event matches.
Result<TimeRange> rangeOf(const SelectionOptions& options, const LogSummary& summary,
                          const std::vector<Event>& events);

/// Which messages of one log are wanted, regardless of time. A datagram is wanted whole or not at
/// all. The recorder's own channels of losses, clock steps and marks are always wanted unless
/// `not_channels` names them; a restated datagram is treated like its channel without
/// /rocinante/restated. Octets and the packet decoded from them are wanted together: their channel
/// decides, and where a source or a device is wanted, the packet. Holds a decoder: use one per
/// thread.
class Selection {
 public:
  /// Wants everything.
  Selection() = default;
  /// `channels` are the log's, and need not outlive the call.
  Selection(const SelectionOptions& options, const std::vector<LogChannel>& channels);

  /// For octets of waitsForPacket() it says what holds without a packet.
  bool includes(const LogMessage& message);
  /// True for octets on whose packet it depends whether both are wanted.
  bool waitsForPacket(const LogMessage& octets) const;
  /// The same for a datagram inside a keyframe, which has no channel.
  bool selectsRestated(const Packet& packet) const;
  /// True when no folded message can be left out.
  bool selectsAll() const { return selects_all_; }

 private:
  enum class Answer : std::uint8_t { no, yes, by_packet, by_restated };

  Answer answerFor(const LogChannel& channel, const SelectionOptions& options) const;
  void joinDecoded(const std::vector<LogChannel>& channels, const SelectionOptions& options);
  bool selectsPacket(const Packet& packet) const;

  bool selects_all_ = true;
  std::vector<Answer> by_channel_;         ///< by channel id
  std::vector<bool> waits_;                ///< by channel id: see waitsForPacket()
  std::vector<std::string> sources_;       ///< patterns; empty: any
  std::vector<std::string> devices_;       ///< patterns; empty: any
  std::vector<std::string> gone_sources_;  ///< sorted; sources that only unwanted channels name
  std::unique_ptr<PacketTextDecoder> decoder_;  ///< null when everything is wanted
};

/// The error for a selection without messages, with the reason if it can be seen: the log is empty
/// or unreadable, the time is outside it, or no topic matches. Call after reading the log.
Error nothingChosen(const LogReader& log, const SelectionOptions& selection,
                    const TimeRange& range);

}  // namespace rocinante
