#include "recorder/contents/message_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/hash.h"
#include "core/base/plain_text.h"

namespace rocinante {
namespace {

constexpr std::size_t kHexBytes = 32;

}  // namespace

std::string payloadLine(ByteView payload, bool is_text) {
  if (!is_text) {
    std::string line = hexOf(payload.first(std::min(payload.size(), kHexBytes)));
    if (payload.size() > kHexBytes) line += "...";
    return fmt::format("{} ({} bytes)", line, payload.size());
  }
  std::string_view text = textOf(payload);
  while (text.ends_with('\n') || text.ends_with('\r') || text.ends_with('\0')) {
    text.remove_suffix(1);
  }
  std::string line;
  while (true) {
    const std::size_t end = text.find('\n');
    std::string_view each = text.substr(0, end);
    if (each.ends_with('\r')) each.remove_suffix(1);
    line += plainText(each);
    if (end == std::string_view::npos) return line;
    line += " | ";
    text.remove_prefix(end + 1);
  }
}

}  // namespace rocinante
