#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/bytes.h"

namespace rocinante {

/// RFC 4648, with padding, in one line.
std::string base64Of(ByteView bytes);
/// Empty when `text` is anything else than what base64Of() writes.
std::optional<Bytes> bytesOfBase64(std::string_view text);

/// The same of a fixed number of bytes: keys and signatures.
template <std::size_t kBytes>
std::string base64Of(const std::array<unsigned char, kBytes>& bytes) {
  return base64Of(std::as_bytes(std::span(bytes)));
}
template <std::size_t kBytes>
std::optional<std::array<unsigned char, kBytes>> readBase64(std::string_view text) {
  const std::optional<Bytes> read = bytesOfBase64(text);
  if (!read || read->size() != kBytes) return std::nullopt;
  std::array<unsigned char, kBytes> bytes{};
  std::ranges::transform(*read, bytes.begin(), std::to_integer<unsigned char>);
  return bytes;
}

}  // namespace rocinante
