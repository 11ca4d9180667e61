#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "viewer/serve/foxglove_desk.h"

namespace rocinante {

/// A client of foxglove.websocket.v1: what it subscribed to, and what it has seen of the desk's
/// channels, which it borrows. A slow one gets the newest messages when its turn comes; nothing
/// waits for it but a few texts. One thread.
class FoxgloveClient {
 public:
  /// A client that asks faster than it listens gets no more answers than these.
  static constexpr std::size_t kMostTexts = 64;

  explicit FoxgloveClient(const FoxgloveDesk& desk);

  /// A message of the client. Any bytes.
  void receive(std::string_view message, bool is_binary);

  struct Outgoing {
    bool is_text = false;
    Bytes bytes;  ///< behind SharedMessage::kRoom
  };
  /// What to send next; empty when there is nothing.
  std::optional<Outgoing> next();

 private:
  struct Subscription {
    std::uint32_t id = 0;
    std::uint64_t seen = 0;  ///< the number of the last message
  };

  void answer(std::string text);
  void subscribe(std::uint32_t id, std::uint32_t channel);
  std::optional<Outgoing> withdrawal();
  std::optional<Outgoing> advertisement();
  std::optional<Outgoing> nextMessage();

  const FoxgloveDesk& desk_;
  std::deque<std::string> texts_;
  std::size_t advertised_ = 0;                           ///< channels
  std::size_t withdrawn_ = 0;                            ///< of the desk's replaced()
  std::map<std::uint32_t, Subscription> subscriptions_;  ///< by channel
  std::map<std::uint32_t, std::uint32_t> channels_;      ///< by the client's number
  std::uint32_t turn_ = 0;                               ///< the channel after the last one sent
};

}  // namespace rocinante
