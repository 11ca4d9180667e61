#include "core/pcap/pcap_filter.h"

#include <fmt/format.h>

#include <cctype>

namespace rocinante {
namespace {

// What a filter with ports sees nothing of. Not IP: tagged, or none of ours. For libpcap not even
// the first fragment of IPv6 has ports.
constexpr std::string_view kHidden =
    "(ip proto 17 and ip[6:2] & 0x3fff != 0) or "
    "(ip6 and (ip6[6] = 0 or ip6[6] = 43 or ip6[6] = 44 or ip6[6] = 60)) or "
    "not (ip or ip6 or arp)";
constexpr std::string_view kWide = "not tcp";

bool hasWord(std::string_view text, std::string_view word) {
  const auto is_letter = [&](std::size_t at) {
    return at < text.size() && std::isalnum(static_cast<unsigned char>(text[at])) != 0;
  };
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) {
    if ((at == 0 || !is_letter(at - 1)) && !is_letter(at + word.size())) return true;
  }
  return false;
}

}  // namespace

bool namesTags(std::string_view user_filter) { return hasWord(user_filter, "vlan"); }

FilterPlan planFilter(std::string_view user_filter) {
  if (user_filter.empty()) return {std::string(kWide), FrameReader::Filtered::before, false};
  if (namesTags(user_filter)) return {std::string(kWide), FrameReader::Filtered::here, true};
  return {fmt::format("(udp and ({})) or {}", user_filter, kHidden), FrameReader::Filtered::before,
          false};
}

}  // namespace rocinante
