#pragma once

#include <cstdint>
#include <string_view>

#include "core/base/bytes.h"
#include "core/foreign/bytes/little_endian.h"

namespace rocinante {

/// Appends one ROS 2 message in CDR, little-endian (OMG DDSI-RTPS 10.2, plain CDR version 1): a
/// header of four bytes, then values aligned to their own size, counted from behind the header.
class CdrWriter {
 public:
  /// Clears `out`, which is borrowed.
  explicit CdrWriter(Bytes& out) : out_(out) {
    out_.assign({std::byte{0}, std::byte{1}, std::byte{0}, std::byte{0}});
  }

  /// A number or a bool (one byte).
  template <class T>
  void put(T value) {
    align(sizeof value);
    appendLittle(out_, value);
  }
  /// Length with the NUL that ends it, then both.
  void text(std::string_view value) {
    put(static_cast<std::uint32_t>(value.size() + 1));
    appendBytes(out_, bytesOf(value));
    out_.push_back(std::byte{0});
  }
  /// Of a sequence, before its elements.
  void count(std::size_t elements) { put(static_cast<std::uint32_t>(elements)); }

 private:
  void align(std::size_t size) {
    constexpr std::size_t kHeaderBytes = 4;
    while ((out_.size() - kHeaderBytes) % size != 0) out_.push_back(std::byte{0});
  }

  Bytes& out_;
};

}  // namespace rocinante
