#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "core/base/bytes.h"

namespace rocinante::mcap {

static_assert(std::endian::native == std::endian::little,
              "MCAP's numbers are copied as they are in memory");

/// Reads MCAP's primitives (all little-endian) one after another from borrowed bytes. Never reads
/// past their end: a read that does not fit fails, and so do all reads after it, so that a whole
/// record can be read before one call of ok().
class ByteCursor {
 public:
  explicit ByteCursor(ByteView bytes) : bytes_(bytes) {}

  bool ok() const { return ok_; }
  std::size_t position() const { return position_; }
  std::size_t remaining() const { return bytes_.size() - position_; }

  template <std::unsigned_integral T>
  T number() {
    T value = 0;
    const ByteView bytes = take(sizeof(T));
    if (ok_) std::memcpy(&value, bytes.data(), sizeof(T));
    return value;
  }

  /// u32 byte length, then the bytes: String, Bytes32, and the frame of Map and Array.
  ByteView bytes32() { return take(number<std::uint32_t>()); }
  /// u64 byte length, then the bytes.
  ByteView bytes64() { return take(number<std::uint64_t>()); }
  std::string_view string() { return textOf(bytes32()); }

  ByteView take(std::uint64_t count) {
    if (!ok_ || count > remaining()) {
      ok_ = false;
      return {};
    }
    const ByteView taken = bytes_.subspan(position_, static_cast<std::size_t>(count));
    position_ += taken.size();
    return taken;
  }

 private:
  ByteView bytes_;
  std::size_t position_ = 0;
  bool ok_ = true;
};

/// Appends a number, least significant byte first.
template <std::unsigned_integral T>
void appendNumber(Bytes& out, T value) {
  const std::size_t start = out.size();
  out.resize(start + sizeof(T));
  std::memcpy(out.data() + start, &value, sizeof(T));
}

inline void appendBytes(Bytes& out, ByteView bytes) {
  out.insert(out.end(), bytes.begin(), bytes.end());
}

/// u32 byte length, then UTF-8.
inline void appendString(Bytes& out, std::string_view text) {
  appendNumber(out, static_cast<std::uint32_t>(text.size()));
  appendBytes(out, bytesOf(text));
}

}  // namespace rocinante::mcap
