#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/bytes.h"
#include "core/base/time.h"
#include "core/net/datagram_source.h"
#include "core/signing/signing_key.h"

namespace rocinante {

/// The most that signing adds to a datagram: ` at=` with 19 digits, the LF of a last line that
/// lacks it, and the line `sig KEYID BASE64` with its LF. Who packs datagrams leaves this room.
inline constexpr std::size_t kSignatureBytes = 23 + 1 + 110;

/// A signed datagram taken apart, not yet verified (docs/signing.md). Borrowed from the datagram.
struct SignedDatagram {
  std::string_view header;  ///< its first line that packet text does not ignore
  std::string_view text;    ///< everything before the signature's line
  bool is_packet = false;   ///< the header begins with RK1, otherwise with RKS1
  std::int64_t at_ns = 0;   ///< when it was signed: nanoseconds since the epoch, signer's clock
  KeyId key = 0;
  Signature signature{};
};

/// Takes a datagram apart. Otherwise returns not_signed or malformed. Any bytes; any thread.
struct ParsedSignature {
  std::optional<Untrusted> fault;
  SignedDatagram datagram;  ///< without a fault
};
ParsedSignature parseSignature(ByteView datagram);

/// Whether the signature is the key's over the signed bytes. `scratch` is memory to reuse.
bool isSignedBy(const PublicKey& key, const SignedDatagram& datagram, std::string& scratch);

/// Signs datagrams with one key. One thread; one for all that a program sends with this key, since
/// receivers demand that `at=` rises.
class DatagramSigner {
 public:
  /// `now` reads the clock that `at=` is taken from.
  DatagramSigner(SigningKey key, std::function<WallTime()> now);

  /// The datagram with `at=` at the end of its first line and a signature in its last; valid until
  /// the next call. An earlier signature and its `at=` are replaced. Empty for bytes that are
  /// neither packet text nor a subscription line, which cannot be signed.
  ByteView sign(ByteView datagram);

  KeyId id() const { return key_.id(); }

 private:
  SigningKey key_;
  std::function<WallTime()> now_;
  std::int64_t last_at_ns_ = 0;
  std::string buffer_;
};

}  // namespace rocinante
