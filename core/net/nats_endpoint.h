#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/time.h"

namespace rocinante {

/// What nats:// and jetstream:// endpoints say beyond their scheme: a server, who asks, and a
/// subject or a stream there. A plain value. Defined by docs/endpoints.md.
struct NatsEndpoint {
  std::string host;  ///< a name, an IPv4 address or an IPv6 address without brackets; not looked up
  std::uint16_t port = 4222;
  std::string user;      ///< alone: a token, or with `seed` the public key of an nkey
  std::string password;  ///< not empty: `user` is a user's name
  bool tls = false;
  std::string authorities;       ///< ca=: PEM file of those who may sign the server's certificate
  std::string certificate, key;  ///< cert=, key=: PEM files, both or neither
  std::string credentials;       ///< creds=: a file with a JWT and its seed
  std::string seed;              ///< nkey=: a file with the seed of `user`

  /// Not part of the text: whether a server that is not there yet is waited for (`--no-wait`).
  bool waits = false;

  std::string subject;  ///< nats only, at most kMaxSubjectBytes
  std::string stream;   ///< jetstream only

  /// jetstream only: the name under which the server keeps how far a recording has come.
  std::string durable = "rocinante";
  /// jetstream only: where a durable begins that the server does not know yet; at most one of them.
  std::optional<std::uint64_t> from_sequence;
  std::optional<WallTime> from_time;

  /// The server as messages name it: "robots.example:4222", "[::1]:4222".
  std::string server() const;
  /// Whether the subject has `*` or `>`: only listeners can have such ones.
  bool hasWildcard() const;
  /// What a listener subscribes to: the subject, and without wildcards everything below it.
  std::string listenedSubject() const;
  bool operator==(const NatsEndpoint&) const = default;
};

/// The longest subject in an endpoint. A SOURCE of 255 bytes, encoded, still fits behind it in the
/// 4,096 bytes that a server reads as one line.
constexpr std::size_t kMaxSubjectBytes = 255;

/// Whether a message on `subject` reaches a subscription to `pattern` (`*`: one word; `>`: one or
/// more, at the end). Both as endpoints have them.
bool subjectMatches(std::string_view pattern, std::string_view subject);

}  // namespace rocinante
