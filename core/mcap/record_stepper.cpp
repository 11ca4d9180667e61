#include "core/mcap/record_stepper.h"

#include <cstring>

namespace rocinante::mcap {

std::optional<Record> recordAt(ByteView bytes, std::uint64_t offset) {
  if (offset > bytes.size() || bytes.size() - offset < kPrefixBytes) return std::nullopt;
  const ByteView rest = bytes.subspan(static_cast<std::size_t>(offset));
  std::uint64_t length = 0;
  std::memcpy(&length, rest.data() + 1, sizeof(length));
  if (length > rest.size() - kPrefixBytes) return std::nullopt;
  return Record{static_cast<Opcode>(rest[0]), offset,
                rest.subspan(kPrefixBytes, static_cast<std::size_t>(length))};
}

}  // namespace rocinante::mcap
