#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/cell/cell.h"
#include "core/foreign/session/message_sink.h"
#include "core/foreign/session/moment_messages.h"

namespace rocinante {

/// The channels of `log export --foxglove` of a live session: of each the newest message, which is
/// whole, and of events the last few. Clients read here what they have not seen. One thread.
class FoxgloveDesk final : public MessageSink {
 public:
  /// Further ones are left out: their names come from strangers.
  static constexpr std::size_t kMostChannels = 4096;
  static constexpr std::size_t kEventsKept = 256;

  struct Message {
    LogTime time{};
    std::uint64_t number = 0;  ///< counts the channel's messages from 1
    Bytes bytes;
  };
  struct Channel {
    std::string advertised;  ///< a text of foxgloveChannel()
    bool keeps_all = false;  ///< of events
    std::deque<Message> messages;
  };

  /// Borrows the cell.
  FoxgloveDesk(const Cell& cell, std::string session);

  /// A packet that the fold has just applied, and its events.
  void applied(const Packet& packet, const std::vector<Event>& events);
  /// Writes what is new in the state; `time` is later than the last one.
  void moment(LogTime time, const SessionState& state);

  Status write(std::string_view topic, const MessageSchema& schema, LogTime time, ByteView message,
               const std::map<std::string, std::string>& metadata) override;

  /// Their numbers are their places; none goes away.
  const std::vector<Channel>& channels() const { return channels_; }
  const std::string& session() const { return session_; }

 private:
  std::string session_;
  std::unique_ptr<SessionFormat> format_;
  MomentMessages messages_;
  std::vector<Channel> channels_;
  std::map<std::string, std::size_t, std::less<>> by_topic_;
  std::vector<Event> events_;  ///< since the last moment, at most kEventsKept
};

}  // namespace rocinante
