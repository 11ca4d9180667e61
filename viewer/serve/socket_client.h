#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "viewer/serve/client_queue.h"
#include "viewer/serve/foxglove_client.h"
#include "viewer/serve/live_session.h"

namespace rocinante {

/// Who looks at a live session through a socket. One thread.
class SocketClient {
 public:
  /// Longer messages end the connection.
  static constexpr std::size_t kMostReceived = 64 * 1024;

  struct Outgoing {
    bool is_text = false;
    SharedMessage message;
  };

  virtual ~SocketClient() = default;

  /// A part of a message; false when the message is too long.
  bool receive(std::string_view part, bool is_first, bool is_last, bool is_binary) {
    if (is_first) received_.clear();
    if (received_.size() + part.size() > kMostReceived) return false;
    received_ += part;
    if (is_last) take(received_, is_binary);
    return true;
  }
  /// A message of the stream that pages share.
  virtual void add(const SharedMessage&) {}
  /// What to send next; empty when there is nothing.
  virtual std::optional<Outgoing> next() = 0;
  /// Messages that it did not get.
  virtual std::uint64_t skipped() const { return 0; }
  /// Reads the live session's desk.
  virtual bool readsDesk() const { return false; }

 private:
  virtual void take(std::string_view message, bool is_binary) = 0;
  std::string received_;
};

/// A page.
class PageSocket final : public SocketClient {
 public:
  /// Borrows the session.
  PageSocket(const LiveSession& live, std::uint64_t most_bytes) : live_(live), queue_(most_bytes) {}

  void add(const SharedMessage& message) override { queue_.add(message); }
  std::optional<Outgoing> next() override {
    if (queue_.empty() && queue_.needsGreeting()) queue_.greet(live_.hub().greeting(live_.now()));
    if (queue_.empty()) return {};
    return Outgoing{false, queue_.take()};
  }
  std::uint64_t skipped() const override { return queue_.skipped(); }

 private:
  void take(std::string_view, bool) override {}  // pages say nothing

  const LiveSession& live_;
  ClientQueue queue_;
};

/// A client of Foxglove's protocol.
class FoxgloveSocket final : public SocketClient {
 public:
  /// Borrows the desk.
  explicit FoxgloveSocket(const FoxgloveDesk& desk) : client_(desk) {}

  std::optional<Outgoing> next() override {
    auto next = client_.next();
    if (!next) return {};
    return Outgoing{next->is_text, SharedMessage(std::move(next->bytes))};
  }
  bool readsDesk() const override { return true; }

 private:
  void take(std::string_view message, bool is_binary) override {
    client_.receive(message, is_binary);
  }
  FoxgloveClient client_;
};

}  // namespace rocinante
