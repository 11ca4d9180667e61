#pragma once

#include <bit>
#include <cstring>
#include <type_traits>

#include "core/base/bytes.h"

namespace rocinante {

static_assert(std::endian::native == std::endian::little,
              "numbers are copied as they are in memory");

/// Appends a number as it is in little-endian formats.
template <class T>
void appendLittle(Bytes& out, T value) {
  static_assert(std::is_arithmetic_v<T>);
  const std::size_t start = out.size();
  out.resize(start + sizeof value);
  std::memcpy(out.data() + start, &value, sizeof value);
}

inline void appendBytes(Bytes& out, ByteView bytes) {
  out.insert(out.end(), bytes.begin(), bytes.end());
}

}  // namespace rocinante
