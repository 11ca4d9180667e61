#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace rocinante {

/// The first 8 bytes of the BLAKE2b-256 of a public key, as a big-endian number: what a signature
/// names its key by.
using KeyId = std::uint64_t;

/// Ed25519 (RFC 8032, by libsodium). Files and bytes: docs/signing.md.
using PublicKey = std::array<unsigned char, 32>;
using Signature = std::array<unsigned char, 64>;

KeyId keyIdOf(const PublicKey& key);
/// 16 lower-case hexadecimal digits.
std::string keyIdText(KeyId id);

/// 44 characters of base64, and back; empty for anything else.
std::string publicKeyText(const PublicKey& key);
std::optional<PublicKey> readPublicKeyText(std::string_view text);

/// Whether `signature` is this key's over `bytes`. Any thread.
bool isSignatureOf(const PublicKey& key, ByteView bytes, const Signature& signature);

/// A key pair. The secret half is wiped from memory at the end.
class SigningKey {
 public:
  /// A new pair, from the system's random numbers.
  static SigningKey make();
  /// The pair of a 32-byte seed: for tests with fixed bytes.
  static SigningKey ofSeed(const std::array<unsigned char, 32>& seed);
  /// The pair in a key file. refused when anyone but the owner may read or write the file; damaged,
  /// with the line, when it is not a key file or its two lines do not belong together.
  static Result<SigningKey> read(const std::filesystem::path& path);
  /// The same from a file's text; `name` is for messages.
  static Result<SigningKey> parse(std::string_view text, const std::string& name);

  ~SigningKey();
  SigningKey(SigningKey&& other) noexcept;
  SigningKey& operator=(SigningKey&& other) noexcept;

  /// Creates the secret file (mode 0600) and beside it PATH.pub with the public line alone. refused
  /// when either exists: a key that is lost cannot be made again.
  Status write(const std::filesystem::path& path) const;

  const PublicKey& publicKey() const { return public_; }
  KeyId id() const { return id_; }
  Signature sign(ByteView bytes) const;

 private:
  SigningKey() = default;

  PublicKey public_{};
  KeyId id_ = 0;
  std::array<unsigned char, 64> secret_{};  ///< libsodium's: the seed, then the public key
};

/// The public key in a key file, with or without its secret line. Fails as SigningKey::read does,
/// but does not ask who may read the file.
Result<PublicKey> readPublicKey(const std::filesystem::path& path);
Result<PublicKey> parsePublicKey(std::string_view text, const std::string& name);

}  // namespace rocinante
