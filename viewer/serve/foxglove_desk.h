#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/cell/cell.h"
#include "core/foreign/session/known_signals.h"
#include "core/foreign/session/message_sink.h"
#include "core/foreign/session/moment_messages.h"

namespace rocinante {

/// The channels of `log export --foxglove` of a live session: of each the newest message, which is
/// whole, and of events the last few. Signals that appear give their channel another schema: a new
/// channel has its topic. Clients read here what they have not seen. One thread.
class FoxgloveDesk final : public MessageSink {
 public:
  /// Further ones are left out: their names come from strangers.
  static constexpr std::size_t kMostChannels = 4096;
  static constexpr std::size_t kMostSignals = 4096;
  /// Of a topic; then its channel stays, and messages have fields that its schema does not name.
  static constexpr std::size_t kMostSchemas = 64;
  static constexpr std::size_t kEventsKept = 256;

  struct Message {
    LogTime time{};
    std::uint64_t number = 0;  ///< counts the channel's messages from 1
    Bytes bytes;
  };
  struct Channel {
    std::string advertised;   ///< a text of foxgloveChannel(); empty once it is replaced
    bool keeps_all = false;   ///< of events
    Bytes schema;             ///< of signals
    std::size_t schemas = 1;  ///< that its topic has had
    std::deque<Message> messages;

    /// Whether another channel has its topic.
    bool isReplaced() const { return advertised.empty(); }
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
  /// The numbers of those that were replaced, in order of time.
  const std::vector<std::uint32_t>& replaced() const { return replaced_; }
  const std::string& session() const { return session_; }

 private:
  void addChannel(std::string_view topic, const MessageSchema& schema);
  bool mayReplace(const Channel& channel, const MessageSchema& schema) const;
  void replace(std::size_t channel, std::string_view topic, const MessageSchema& schema);

  std::string session_;
  std::unique_ptr<SessionFormat> format_;
  KnownSignals known_{kMostSignals};
  std::uint64_t known_growth_ = 0;  ///< that the format knows
  MomentMessages messages_;
  std::vector<Channel> channels_;
  std::vector<std::uint32_t> replaced_;
  std::map<std::string, std::size_t, std::less<>> by_topic_;
  std::vector<Event> events_;  ///< since the last moment, at most kEventsKept
};

}  // namespace rocinante
