#include "core/base/hash.h"

#include <isa-l/crc.h>
#include <sodium/crypto_hash_sha256.h>
#include <xxhash.h>
#include <zlib.h>

#include <cstring>
#include <new>

namespace rocinante {

std::uint32_t crc32(ByteView bytes, std::uint32_t previous) {
  // ISA-L's version, chosen by CPU features: 15 times as fast as zlib's.
  return ::crc32_gzip_refl(previous, reinterpret_cast<const unsigned char*>(bytes.data()),
                           bytes.size());
}

std::uint32_t crc32Combine(std::uint32_t a, std::uint32_t b, std::uint64_t b_bytes) {
  return static_cast<std::uint32_t>(::crc32_combine64(a, b, static_cast<z_off64_t>(b_bytes)));
}

struct Sha256::State {
  crypto_hash_sha256_state context;
};

Sha256::Sha256() : state_(std::make_unique<State>()) { crypto_hash_sha256_init(&state_->context); }
Sha256::~Sha256() = default;
Sha256::Sha256(Sha256&&) noexcept = default;
Sha256& Sha256::operator=(Sha256&&) noexcept = default;

void Sha256::add(ByteView bytes) {
  crypto_hash_sha256_update(&state_->context, reinterpret_cast<const unsigned char*>(bytes.data()),
                            bytes.size());
}

void Sha256::addU64(std::uint64_t number) {
  std::array<std::byte, 8> little_endian;
  for (auto& byte : little_endian) {
    byte = static_cast<std::byte>(number & 0xFFU);
    number >>= 8U;
  }
  add(little_endian);
}

Sha256::Digest Sha256::finish() {
  Digest digest;
  crypto_hash_sha256_final(&state_->context, reinterpret_cast<unsigned char*>(digest.data()));
  crypto_hash_sha256_init(&state_->context);
  return digest;
}

namespace {

Xxh3::Digest canonicalOf(XXH128_hash_t hash) {
  XXH128_canonical_t canonical;
  XXH128_canonicalFromHash(&canonical, hash);
  Xxh3::Digest digest;
  std::memcpy(digest.data(), canonical.digest, digest.size());
  return digest;
}

}  // namespace

std::array<std::byte, 16> xxh3(ByteView bytes) {
  return canonicalOf(XXH3_128bits(bytes.data(), bytes.size()));
}

namespace {

/// Its size is the library's secret, which also aligns it.
XXH3_state_t* libraryState(void* state) { return static_cast<XXH3_state_t*>(state); }

}  // namespace

Xxh3::Xxh3() : state_(reinterpret_cast<State*>(XXH3_createState())) {
  if (!state_) throw std::bad_alloc();
  XXH3_128bits_reset(libraryState(state_.get()));
}

void Xxh3::Free::operator()(State* state) const { XXH3_freeState(libraryState(state)); }

void Xxh3::add(ByteView bytes) {
  XXH3_128bits_update(libraryState(state_.get()), bytes.data(), bytes.size());
}

Xxh3::Digest Xxh3::digest() const {
  return canonicalOf(XXH3_128bits_digest(libraryState(state_.get())));
}

std::string hexOf(ByteView bytes) {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  text.reserve(bytes.size() * 2);
  for (const std::byte byte : bytes) {
    text.push_back(kDigits[std::to_integer<unsigned>(byte) >> 4U]);
    text.push_back(kDigits[std::to_integer<unsigned>(byte) & 15U]);
  }
  return text;
}

}  // namespace rocinante
