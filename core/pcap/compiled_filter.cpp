#include "core/pcap/compiled_filter.h"

#include <fmt/format.h>
#include <pcap/pcap.h>

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

}  // namespace rocinante
