#include "core/pcap/pcap_filter.h"

#include <fmt/format.h>

#include <cctype>

namespace rocinante {
namespace {

// All UDP fragments: for libpcap not even the first fragment of IPv6 has ports.
constexpr std::string_view kFragments =
    "(ip proto 17 and ip[6:2] & 0x3fff != 0) or (ip6[6] = 44 and ip6[40] = 17)";

bool hasWord(std::string_view text, std::string_view word) {
  const auto is_letter = [&](std::size_t at) {
    return at < text.size() && std::isalnum(static_cast<unsigned char>(text[at])) != 0;
  };
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) {
    if ((at == 0 || !is_letter(at - 1)) && !is_letter(at + word.size())) return true;
  }
  return false;
}

/// All UDP, with up to two VLAN tags. `vlan` shifts the offsets of everything after it, so it comes
/// last.
std::string allUdp(LinkType link) {
  if (link != LinkType::ethernet) return "udp";
  return "udp or (vlan and (udp or (vlan and udp)))";
}

}  // namespace

FilterPlan planFilter(std::string_view user_filter, LinkType link) {
  if (user_filter.empty()) return {allUdp(link), FrameReader::Filtered::before};
  if (hasWord(user_filter, "vlan")) return {allUdp(link), FrameReader::Filtered::here};
  return {fmt::format("({}) or (udp and ({}))", kFragments, user_filter),
          FrameReader::Filtered::before};
}

}  // namespace rocinante
