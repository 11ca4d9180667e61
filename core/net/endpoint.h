#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/net/nats_endpoint.h"

namespace rocinante {

/// An IPv4 or IPv6 address with a port. A plain value.
struct SocketAddress {
  bool is_ipv6 = false;
  std::array<std::uint8_t, 16> address{};  ///< network order; IPv4 uses the first four bytes
  std::uint16_t port = 0;
  std::uint32_t scope_id = 0;  ///< IPv6 link-local: the interface's index

  /// A dotted quad or a bare IPv6 address, link-local ones with %ZONE; looks up no names.
  static Result<SocketAddress> parse(std::string_view host, std::uint16_t port);

  bool isMulticast() const;
  bool isAny() const;
  bool isLinkLocal() const;      ///< of IPv6: every interface may have the same address
  std::string hostText() const;  ///< "127.0.0.1", "fe80::1%eth0"
  std::string text() const;      ///< "127.0.0.1:19960", "[::1]:19960"
  bool operator==(const SocketAddress&) const = default;
};

/// The source or destination of datagrams, as a user writes it:
/// udp://HOST:PORT, udp://GROUP:PORT?interface=eth0&ttl=1&source=IP, [V6]:PORT, HOST:PORT, :PORT;
/// for receivers also pcap://INTERFACE?filter=EXPR, pcap:///FILE and
/// subscribe://HOST:PORT?device=PATTERN&signal=PATTERN&source=PATTERN&min-change=WHAT=X&rate=HZ,
/// and jetstream://HOST:4222/STREAM?from=SEQUENCE; nats://[USER:PASSWORD@]HOST:4222/SUBJECT for
/// both. Defined by docs/endpoints.md.
struct Endpoint {
  enum class Scheme { udp, pcap, subscribe, nats, jetstream };

  /// What a subscription asks its relay for. Patterns as in docs/patterns.md.
  struct Selection {
    std::string source;             ///< of SOURCEs; empty: all
    std::string device;             ///< of devices; empty: all
    std::optional<double> rate_hz;  ///< at most this many values a device and second; above 0
    std::string signal{};           ///< of signals, `PATH NAME`; empty: all
    std::string min_change{};       ///< as MinChange::addAll() takes it; empty: none
    bool operator==(const Selection&) const = default;
  };

  Scheme scheme = Scheme::udp;
  /// ":PORT" is 0.0.0.0 for a listener; nothing for pcap, nats and jetstream; the relay's for
  /// subscribe.
  SocketAddress address;
  std::string interface;   ///< multicast and pcap only; empty: the system chooses, or `file` is set
  std::string filter;      ///< pcap only: tcpdump's syntax; empty: all UDP
  std::string file;        ///< pcap only: a capture to read, instead of an interface
  std::optional<int> ttl;  ///< 0..255; multicast hops, or unicast time to live
  /// Multicast only: a receiver accepts this sender alone, a sender sends from this address. Port
  /// 0.
  std::optional<SocketAddress> source;
  Selection selection;  ///< subscribe only
  NatsEndpoint nats;    ///< nats and jetstream only

  /// bad_argument with the reason and the text; unsupported for the schemes of later versions.
  /// Looks up host names (getaddrinfo; refused when that fails), but not numeric addresses.
  static Result<Endpoint> parse(std::string_view text);
  /// What parse() refuses of the text before it would look up a name, which is done nowhere here.
  static Status check(std::string_view text);
  /// udp://239.255.19.96:19960?interface=lo&ttl=0
  static Endpoint standard();

  bool isMulticast() const { return address.isMulticast(); }
  /// Watches traffic addressed to other programs: UdpReceiver and UdpSender refuse it.
  bool isPcap() const { return scheme == Scheme::pcap; }
  /// Receives from a relay that was asked to send: UdpReceiver and UdpSender refuse it.
  bool isSubscription() const { return scheme == Scheme::subscribe; }
  /// A subject of a NATS server, or a stream that it keeps.
  bool isNats() const { return scheme == Scheme::nats || scheme == Scheme::jetstream; }
  /// Has times of its own, not those of arrival: a capture file or a stream.
  bool hasOwnTimes() const { return !file.empty() || scheme == Scheme::jetstream; }
  /// The canonical form; parse(text()) gives the same endpoint, but for what stands before the @ of
  /// nats:// and jetstream://, which no message or log shows.
  std::string text() const;
  bool operator==(const Endpoint&) const = default;
};

}  // namespace rocinante
