#include "viewer/picture/exr_guard.h"

namespace rocinante {
namespace {

std::uint32_t littleEndian(std::string_view four) {
  std::uint32_t number = 0;
  for (std::size_t i = 4; i-- > 0;) number = number << 8U | static_cast<unsigned char>(four[i]);
  return number;
}

/// Checks an attribute of type chlist: each channel is a name, a type (0 to 2) and twelve more
/// bytes.
bool knowsChannelTypes(std::string_view list) {
  std::size_t at = 0;
  while (at < list.size() && list[at] != '\0') {
    const std::size_t name_end = list.find('\0', at);
    if (name_end == list.npos || list.size() - name_end < 17) return false;
    if (littleEndian(list.substr(name_end + 1, 4)) > 2) return false;
    at = name_end + 17;
  }
  return true;
}

}  // namespace

std::string_view exrFault(std::string_view head, std::uint64_t file_bytes) {
  constexpr std::uint32_t kSeveralParts = 0x1000;
  if (head.size() < 8 || !head.starts_with("\x76\x2F\x31\x01")) return "";
  const bool several_parts = (littleEndian(head.substr(4)) & kSeveralParts) != 0;
  std::size_t at = 8;
  bool header_is_empty = true;
  while (at < head.size()) {
    if (head[at] == '\0') {
      if (!several_parts || header_is_empty) return "";
      header_is_empty = true;
      ++at;
      continue;
    }
    header_is_empty = false;
    const std::size_t name_end = head.find('\0', at);
    const std::size_t type_end = name_end == head.npos ? head.npos : head.find('\0', name_end + 1);
    if (type_end == head.npos || head.size() - type_end < 5) return "";
    const std::uint32_t size = littleEndian(head.substr(type_end + 1, 4));
    const std::uint64_t content = type_end + 5;
    if (size > file_bytes - content) return "is cut short";
    const std::string_view type = head.substr(name_end + 1, type_end - name_end - 1);
    if (type == "chlist" && content + size <= head.size() &&
        !knowsChannelTypes(head.substr(static_cast<std::size_t>(content), size))) {
      return "cannot be decoded: it has a channel of an unknown type";
    }
    at = static_cast<std::size_t>(content + size);
  }
  return "";
}

}  // namespace rocinante
