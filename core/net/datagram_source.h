#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/base/time.h"
#include "core/net/endpoint.h"

namespace rocinante {

class Account;

/// A datagram as the socket gave it.
struct ReceivedDatagram {
  ByteView payload;  ///< borrowed from the source until its next receive()
  SocketAddress sender;
  WallTime kernel_time{};  ///< the kernel's stamp (SO_TIMESTAMPNS), CLOCK_REALTIME
  bool truncated = false;
  /// The destination, from a source that watches others' traffic; borrowed like the payload. Null:
  /// the source's boundAddress().
  const SocketAddress* destination = nullptr;
  /// The subject of a message of a NATS server, whose sender is then unknown (0.0.0.0:0); borrowed
  /// like the payload. Empty: a datagram of the network.
  std::string_view subject = {};
};

/// Why a datagram is refused where senders must sign (docs/signing.md), in the order of the checks.
enum class Untrusted : std::uint8_t {
  not_signed,   ///< it has no signature, or is neither packet text nor a subscription line
  malformed,    ///< its signature, its first line or its `at=` is malformed
  unknown_key,  ///< the trust file does not list its key
  not_allowed,  ///< its key may not say this
  out_of_time,  ///< its `at=` is too far from the receiver's clock
  repeated,     ///< its `at=` was seen before, or is older than what is remembered of the key
  forged,       ///< the signature does not match the bytes
};
inline constexpr std::size_t kUntrustedReasons = 7;

/// "not_signed" and so on: the names in reports.
std::string_view nameOf(Untrusted reason);

/// Datagrams refused, by reason.
struct UntrustedCounts {
  std::array<std::uint64_t, kUntrustedReasons> by_reason{};

  void add(Untrusted reason) { ++by_reason[static_cast<std::size_t>(reason)]; }
  std::uint64_t of(Untrusted reason) const { return by_reason[static_cast<std::size_t>(reason)]; }
  std::uint64_t total() const;
  UntrustedCounts& operator+=(const UntrustedCounts& others);
  /// "3 not signed, 1 forged"; empty when there are none.
  std::string text() const;
  bool operator==(const UntrustedCounts&) const = default;
};

/// Arrivals that a source did not pass on. None of them is a loss: they were not wanted, or were
/// not datagrams.
struct InputCounts {
  std::uint64_t refused = 0;     ///< datagrams from a sender that is not allowed
  std::uint64_t strangers = 0;   ///< to a subscription, from another address than its relay's
  std::uint64_t requests = 0;    ///< lines between subscribers and relays (RKS1)
  std::uint64_t echoes = 0;      ///< datagrams that this program itself forwarded
  std::uint64_t incomplete = 0;  ///< datagrams with missing or contradictory fragments
  std::uint64_t malformed = 0;   ///< frames that break the rules of IP or UDP
  std::uint64_t other = 0;       ///< frames that are not UDP
  /// Datagrams refused where senders must sign; empty where they need not.
  std::optional<UntrustedCounts> untrusted;
  bool operator==(const InputCounts&) const = default;
};

/// What became of a subscription (subscribe://).
struct SubscriptionOutcome {
  /// From the first request to the first acceptance; empty: never accepted.
  std::optional<Nanoseconds> accepted_after;
  std::string trouble;  ///< why it was never accepted: "never answered"; else empty
};

/// A source of datagrams: a UDP socket, watched traffic, a server's subject, or a test's fake. One
/// thread.
class DatagramSource {
 public:
  virtual ~DatagramSource() = default;

  /// The waiting datagrams, up to a batch; empty when there are none. Never blocks.
  virtual Result<std::span<const ReceivedDatagram>> receive() = 0;

  /// Datagrams dropped before they could be received, as reported with those received so far.
  virtual std::uint64_t dropped() const = 0;
  /// The same, queried now: also counts drops after the last datagram received. Never decreases.
  virtual Result<std::uint64_t> droppedByNow() = 0;
  virtual InputCounts counts() const { return {}; }
  /// Empty: it is not a subscription.
  virtual std::optional<SubscriptionOutcome> subscription() const { return std::nullopt; }

  /// To be called now and then when receive() gave nothing: repairs what the system took away, such
  /// as the membership of a group whose interface was recreated, and keeps a subscription
  /// (receive() does that too). Returns a sentence for the user when this changes what is received.
  virtual std::optional<std::string> maintain() { return std::nullopt; }
  /// The longest that the kernel may delay delivery: 0 for a socket.
  virtual Nanoseconds deliveryDelay() const { return Nanoseconds(0); }
  /// Nothing more will ever arrive: the end of a capture file.
  virtual bool ended() const { return false; }
  /// It continues next time after the datagrams that confirm() named (jetstream://).
  virtual bool keepsPlace() const { return false; }
  /// The first `count` of the datagrams ever received are safely kept by the caller.
  virtual void confirm(std::uint64_t count) { (void)count; }
  /// For poll(); -1: there is none, ask again in a few milliseconds. May change with maintain().
  virtual int fileDescriptor() const { return -1; }
  /// The buffer for waiting datagrams that the kernel granted, as it counts it; 0: not a socket.
  virtual std::uint64_t receiveBufferBytes() const { return 0; }

  /// What its NATS server calls itself, whatever name it was reached by; empty: not known (yet).
  virtual std::string serverId() const { return {}; }
  virtual const Endpoint& endpoint() const = 0;
  /// The endpoint's address with the port that was bound (":0" takes a free one). Of a
  /// subscription: the own address that the relay sends to.
  virtual const SocketAddress& boundAddress() const = 0;

  /// What arrived and is not passed on, by kind: of watched traffic frames that are not UDP.
  virtual Account leftOut() const;
};

/// A source's endpoint with the port that was bound, as shown to users. A subscription keeps the
/// relay's port.
std::string boundText(const Endpoint& endpoint, const SocketAddress& bound);
std::string boundText(const DatagramSource& source);

/// "subscribe://HOST:PORT: never answered", for the end of a program; empty: the relay accepted, or
/// it is not a subscription.
std::optional<std::string> neverAcceptedText(const DatagramSource& source);

}  // namespace rocinante
