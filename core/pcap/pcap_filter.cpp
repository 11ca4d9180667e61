#include "core/pcap/pcap_filter.h"

#include <fmt/format.h>
#include <pcap/pcap.h>

#include <cctype>
#include <map>
#include <memory>

namespace rocinante {
namespace {

constexpr int kLongestFrame = 262'144;

struct FreeProgram {
  void operator()(bpf_program* program) const {
    ::pcap_freecode(program);
    delete program;
  }
};
using Program = std::unique_ptr<bpf_program, FreeProgram>;

struct CloseDead {
  void operator()(pcap_t* handle) const { ::pcap_close(handle); }
};

Result<Program> compiled(const std::string& text, LinkType link) {
  const std::unique_ptr<pcap_t, CloseDead> dead(
      ::pcap_open_dead(linkTypeNumber(link), kLongestFrame));
  auto program = std::make_unique<bpf_program>();
  if (::pcap_compile(dead.get(), program.get(), text.c_str(), 1, PCAP_NETMASK_UNKNOWN) != 0) {
    return Error{ErrorKind::bad_argument,
                 fmt::format("libpcap rejects this filter: {}", ::pcap_geterr(dead.get())),
                 {}};
  }
  return Program(program.release());
}

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

Result<FrameReader::Filter> compiledFilter(const std::string& text, LinkType first) {
  Result<Program> program = compiled(text, first);
  if (!program) return program.error();
  const auto programs = std::make_shared<std::map<LinkType, Program>>();
  programs->emplace(first, std::move(*program));
  return FrameReader::Filter([text, programs](LinkType link, ByteView frame) {
    auto known = programs->find(link);
    if (known == programs->end()) {
      Result<Program> made = compiled(text, link);
      known = programs->emplace(link, made ? std::move(*made) : Program()).first;
    }
    if (known->second == nullptr) return false;
    pcap_pkthdr header{};
    header.caplen = header.len = static_cast<bpf_u_int32>(frame.size());
    return ::pcap_offline_filter(known->second.get(), &header,
                                 reinterpret_cast<const unsigned char*>(frame.data())) != 0;
  });
}

bool namesTags(std::string_view user_filter) { return hasWord(user_filter, "vlan"); }

FilterPlan planFilter(std::string_view user_filter) {
  if (user_filter.empty()) return {std::string(kWide), FrameReader::Filtered::before, false};
  if (namesTags(user_filter)) return {std::string(kWide), FrameReader::Filtered::here, true};
  return {fmt::format("(udp and ({})) or {}", user_filter, kHidden), FrameReader::Filtered::before,
          false};
}

}  // namespace rocinante
