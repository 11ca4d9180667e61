#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "core/signing/signed_datagram.h"
#include "core/signing/trust_file.h"

namespace rocinante::test {

/// The key of the vectors in docs/signing.md: the seed is 00 01 02 ... 1f.
inline SigningKey vectorKey(unsigned char first = 0) {
  std::array<unsigned char, 32> seed{};
  for (unsigned char& each : seed) each = first++;
  return SigningKey::ofSeed(seed);
}

inline constexpr std::string_view kVectorPublic = "A6EHv/POEL4dcN0Y50vAmWfk1jCbpQ1fHdyGZBJVMbg=";
inline constexpr std::string_view kVectorSecret = "AAECAwQFBgcICQoLDA0ODxAREhMUFRYXGBkaGxwdHh8=";
inline constexpr std::string_view kVectorId = "9d24e2eeaf27c2a0";

/// Made by OpenSSL, independently of the library that we use.
inline constexpr std::string_view kUnsignedPacket =
    "RK1 arm@7f3a 41 1700000000.25\n"
    "joints puma 0 -0.785 1.57\n";
inline constexpr std::string_view kSignedPacket =
    "RK1 arm@7f3a 41 1700000000.25 at=1700000000250000001\n"
    "joints puma 0 -0.785 1.57\n"
    "sig 9d24e2eeaf27c2a0 "
    "tTkCgcjEEBikj/3htwV45WoleC4BCNQkUyaahP8mw0VfSSbKaJzSHkmtAgxc83+HjHbbwuRhfd3+2S+VlDuQCw==\n";
inline constexpr std::string_view kSignedKeep =
    "RKS1 keep id=00000000000000ff at=1700000000250000002\n"
    "sig 9d24e2eeaf27c2a0 "
    "ScHTU1u8QT5VcYEUaNDotzNIMHN9vr01VwTt0OIY1N42Fc6ixKOMPhEe+iE3vPDi2rd0hM/t+sEa09HlrjWKCw==\n";
inline constexpr std::int64_t kVectorAt = 1'700'000'000'250'000'001;

inline WallTime wallAt(std::int64_t ns) { return WallTime(Nanoseconds(ns)); }

/// Signs with a clock that says `at_ns`.
inline std::string signedText(std::string_view datagram, std::int64_t at_ns = kVectorAt,
                              unsigned char first = 0) {
  DatagramSigner signer(vectorKey(first), [at_ns] { return wallAt(at_ns); });
  return std::string(textOf(signer.sign(bytesOf(datagram))));
}

inline TrustFile trusting(const SigningKey& key, std::vector<std::string> sources,
                          bool is_relay = false) {
  TrustFile file;
  file.keys.push_back({key.id(), key.publicKey(), std::move(sources), is_relay});
  return file;
}

}  // namespace rocinante::test
