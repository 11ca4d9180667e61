#include "viewer/picture/exr_guard.h"

namespace rocinante {
namespace {

std::uint32_t littleEndian(std::string_view four) {
  std::uint32_t number = 0;
  for (std::size_t i = 4; i-- > 0;) number = number << 8U | static_cast<unsigned char>(four[i]);
  return number;
}

}  // namespace

bool exrAttributesFit(std::string_view head, std::uint64_t file_bytes) {
  constexpr std::uint32_t kSeveralParts = 0x1000;
  if (head.size() < 8 || !head.starts_with("\x76\x2F\x31\x01")) return true;
  const bool several_parts = (littleEndian(head.substr(4)) & kSeveralParts) != 0;
  std::size_t at = 8;
  bool header_is_empty = true;
  while (at < head.size()) {
    if (head[at] == '\0') {
      if (!several_parts || header_is_empty) return true;
      header_is_empty = true;
      ++at;
      continue;
    }
    header_is_empty = false;
    const std::size_t name_end = head.find('\0', at);
    const std::size_t type_end =
        name_end == head.npos ? head.npos : head.find('\0', name_end + 1);
    if (type_end == head.npos || head.size() - type_end < 5) return true;
    const std::uint32_t size = littleEndian(head.substr(type_end + 1, 4));
    const std::uint64_t content = type_end + 5;
    if (size > file_bytes - content) return false;
    at = static_cast<std::size_t>(content + size);
  }
  return true;
}

}  // namespace rocinante
