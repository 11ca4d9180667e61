#pragma once

#include <sodium.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace rocinante {

/// Base64 (RFC 4648, with padding) of a fixed number of bytes.
template <std::size_t kBytes>
std::string base64Of(const std::array<unsigned char, kBytes>& bytes) {
  std::array<char, sodium_base64_ENCODED_LEN(kBytes, sodium_base64_VARIANT_ORIGINAL)> text{};
  ::sodium_bin2base64(text.data(), text.size(), bytes.data(), kBytes,
                      sodium_base64_VARIANT_ORIGINAL);
  return {text.data(), text.size() - 1};
}

/// The bytes that base64Of() writes as `text`; empty for any other spelling.
template <std::size_t kBytes>
std::optional<std::array<unsigned char, kBytes>> readBase64(std::string_view text) {
  std::array<unsigned char, kBytes> bytes{};
  std::size_t length = 0;
  if (::sodium_base642bin(bytes.data(), kBytes, text.data(), text.size(), nullptr, &length, nullptr,
                          sodium_base64_VARIANT_ORIGINAL) != 0 ||
      length != kBytes) {
    return std::nullopt;
  }
  // libsodium takes some characters with their highest bit set for those without.
  if (base64Of(bytes) != text) return std::nullopt;
  return bytes;
}

}  // namespace rocinante
