#pragma once

#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/net/datagram_sink.h"
#include "core/net/udp_socket.h"
#include "core/relay/fan_out.h"
#include "core/relay/relay.h"
#include "core/subscription/subscription_desk.h"

namespace rocinante {

/// One `--serve` endpoint: a socket for requests and answers, and for what goes to subscribers. One
/// thread.
class ServePort {
 public:
  /// Fails as UdpReceiver::open; bad_argument for a group, which cannot be asked.
  static Result<std::unique_ptr<ServePort>> open(const Endpoint& at,
                                                 SubscriptionDesk::Options options,
                                                 std::size_t signature_bytes);

  /// Answers the waiting requests, and opens, closes and greets the outputs of subscribers.
  Status handleRequests(Relay& relay, const RelayOutputOptions& defaults, SteadyTime now,
                        LogTime log_now);
  /// Sends what goes to its subscribers.
  void send(std::span<const Relay::Outgoing> outgoing);

  const UdpReceiver& socket() const { return socket_; }
  const SubscriptionDesk& desk() const { return desk_; }
  std::uint64_t forwarded() const { return forwarded_; }
  std::uint64_t dropped() const { return dropped_; }
  /// Values that its subscribers, of now and before, were spared by newer ones.
  std::uint64_t conflated(const Relay& relay) const;
  /// What its subscribers, of now and before, did not get by their filters.
  FilteredOutCounts filteredOut(const Relay& relay) const;
  /// Statements that wait for the links of its subscribers; those of subscribers that left do not.
  PacedCounts paced(const Relay& relay) const;

 private:
  struct Subscriber {
    Relay::OutputId output = 0;
    FanOut::Destination address;
  };
  ServePort(UdpReceiver socket, SubscriptionDesk::Options options, std::size_t signature_bytes);
  void begin(const SocketAddress& from, const SubscriptionWish& wish, Relay& relay,
             const RelayOutputOptions& defaults, LogTime now);
  void end(const SocketAddress& from, Relay& relay);
  void flush();
  bool waitForRoom();

  UdpReceiver socket_;
  SubscriptionDesk desk_;
  std::size_t signature_bytes_;  ///< of what goes to its subscribers
  FanOut fan_out_;
  std::unordered_map<std::string, Relay::OutputId> by_address_;
  std::unordered_map<Relay::OutputId, Subscriber> subscribers_;
  std::vector<Relay::OutputId> whole_;
  std::uint64_t forwarded_ = 0;
  std::uint64_t dropped_ = 0;
  std::uint64_t conflated_ = 0;     ///< for subscribers that have gone
  FilteredOutCounts filtered_out_;  ///< likewise
  PacedCounts paced_;               ///< likewise
};

/// One `--to` endpoint. One thread.
struct ToPort {
  std::unique_ptr<DatagramSink> sink;
  Relay::OutputId output = 0;
  bool whole = true;
  std::uint64_t forwarded = 0;
  std::uint64_t dropped = 0;
  std::optional<Error> trouble;
  std::vector<ByteView> payloads;  ///< scratch

  /// Sends what goes to it.
  void send(std::span<const Relay::Outgoing> outgoing);
};

/// Waits up to 2 ms until the descriptor is writable; false when it is not.
bool waitUntilWritable(int descriptor);

}  // namespace rocinante
