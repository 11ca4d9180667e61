#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "core/base/bytes.h"

namespace rocinante {

/// CRC-32/IEEE (zlib's): polynomial 0xEDB88320 reflected, initial and final xor 0xFFFFFFFF.
/// `previous` continues an earlier checksum: crc32(b, crc32(a)) == crc32(a followed by b).
std::uint32_t crc32(ByteView bytes, std::uint32_t previous = 0);

/// The checksum of a followed by b, from their checksums and b's length alone.
std::uint32_t crc32Combine(std::uint32_t a, std::uint32_t b, std::uint64_t b_bytes);

/// SHA-256 fed piece by piece (FIPS 180-4, by libsodium).
class Sha256 {
 public:
  using Digest = std::array<std::byte, 32>;

  Sha256();
  ~Sha256();
  Sha256(Sha256&&) noexcept;
  Sha256& operator=(Sha256&&) noexcept;

  void add(ByteView bytes);
  /// Eight bytes, least significant first.
  void addU64(std::uint64_t number);
  /// The digest of everything added; the object starts over.
  Digest finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// XXH3 with 128 bits, canonical (big-endian) form: for pictures and other hot paths.
std::array<std::byte, 16> xxh3(ByteView bytes);

/// The same, fed piece by piece.
class Xxh3 {
 public:
  using Digest = std::array<std::byte, 16>;

  Xxh3();

  void add(ByteView bytes);
  /// The digest of everything added; more may be added.
  Digest digest() const;

 private:
  struct State;
  struct Free {
    void operator()(State* state) const;
  };
  std::unique_ptr<State, Free> state_;
};

/// Lower-case hexadecimal.
std::string hexOf(ByteView bytes);

}  // namespace rocinante
