#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace rocinante {

/// Bytes of a file: [first, first + count).
struct ByteRange {
  std::uint64_t first = 0, count = 0;
  bool operator==(const ByteRange&) const = default;
};

/// What a header `Range: bytes=FIRST-LAST`, `FIRST-` or `-LENGTH` asks for of a file of `size`
/// bytes; only one range. Empty: it is not of this form, and the whole file is the answer (RFC
/// 9110, 14.2). A range of no bytes: outside the file (status 416).
std::optional<ByteRange> parseByteRange(std::string_view header, std::uint64_t size);

}  // namespace rocinante
