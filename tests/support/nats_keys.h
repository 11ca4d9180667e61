#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/bytes.h"
#include "core/signing/signing_key.h"

namespace rocinante::test {

/// A key pair in the spelling of NATS: Ed25519, in base32 behind a byte for its kind, with a CRC.
class NatsKey {
 public:
  /// The first byte: the first letter of the public text is O, A or U.
  enum Kind : unsigned char { kOperator = 14 << 3, kAccount = 0, kUser = 20 << 3 };

  NatsKey(Kind kind, unsigned char seed) : kind_(kind), key_(SigningKey::ofSeed(seedOf(seed))) {
    for (const unsigned char each : seedOf(seed)) seed_ += static_cast<char>(each);
  }

  std::string publicText() const {
    std::string bytes(1, static_cast<char>(kind_));
    for (const unsigned char each : key_.publicKey()) bytes += static_cast<char>(each);
    return checkedText(bytes);
  }
  std::string seedText() const {
    constexpr unsigned char kSeed = 18 << 3;
    std::string bytes;
    bytes += static_cast<char>(kSeed | kind_ >> 5U);
    bytes += static_cast<char>((kind_ & 31U) << 3U);
    return checkedText(bytes + seed_);
  }
  /// A JSON Web Token with which this key says that `subject` is `what`, in JSON.
  std::string token(const NatsKey& subject, const std::string& what) const {
    const std::string claims = R"({"jti":"x","iat":1700000000,"iss":")" + publicText() +
                               R"(","sub":")" + subject.publicText() +
                               R"(","name":"cell","nats":)" + what + "}";
    const std::string text = base64(R"({"typ":"JWT","alg":"ed25519-nkey"})") + "." + base64(claims);
    std::string signature;
    for (const unsigned char each : key_.sign(bytesOf(text))) signature += static_cast<char>(each);
    return text + "." + base64(signature);
  }

 private:
  static std::array<unsigned char, 32> seedOf(unsigned char first) {
    std::array<unsigned char, 32> seed{};
    for (unsigned char& each : seed) each = first++;
    return seed;
  }
  /// `width` bits a character, without padding.
  static std::string inBase(std::string_view alphabet, unsigned width, std::string_view bytes) {
    std::string text;
    std::uint32_t held = 0;
    unsigned bits = 0;
    for (const char each : bytes) {
      held = held << 8U | static_cast<unsigned char>(each);
      for (bits += 8; bits >= width; bits -= width) {
        text += alphabet[held >> (bits - width) & ((1U << width) - 1)];
      }
    }
    if (bits > 0) text += alphabet[held << (width - bits) & ((1U << width) - 1)];
    return text;
  }
  static std::string base64(std::string_view bytes) {
    return inBase("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_", 6, bytes);
  }
  /// With CRC-16/XMODEM, its low byte first.
  static std::string checkedText(std::string bytes) {
    std::uint32_t crc = 0;
    for (const char each : bytes) {
      crc ^= std::uint32_t{static_cast<unsigned char>(each)} << 8U;
      for (int bit = 0; bit < 8; ++bit) {
        crc = (crc << 1U ^ ((crc & 0x8000U) != 0 ? 0x1021U : 0U)) & 0xFFFFU;
      }
    }
    bytes += static_cast<char>(crc & 0xFFU);
    bytes += static_cast<char>(crc >> 8U);
    return inBase("ABCDEFGHIJKLMNOPQRSTUVWXYZ234567", 5, bytes);
  }

  Kind kind_;
  SigningKey key_;
  std::string seed_;
};

}  // namespace rocinante::test
