#include <algorithm>
#include <optional>

#include "core/base/hex_digit.h"
#include "core/net/endpoint_text.h"

namespace rocinante {
namespace {

constexpr std::string_view kFilter = "filter=";

}  // namespace

std::optional<std::string> decodePercent(std::string_view text) {
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); ++i) {
    char byte = text[i];
    if (byte == '%') {
      const std::optional<char> decoded = percentByte(text, i);
      if (!decoded) return std::nullopt;
      byte = *decoded;
      i += 2;
    }
    if (byte == '\0' || byte == '\n' || byte == '\r') return std::nullopt;
    bytes.push_back(byte);
  }
  return bytes;
}

std::string encodePercent(std::string_view text, std::string_view also) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string word;
  for (const char c : text) {
    if (c > ' ' && c <= '~' && c != '%' && also.find(c) == also.npos) {
      word.push_back(c);
      continue;
    }
    const auto byte = static_cast<unsigned char>(c);
    word += {'%', kDigits[byte >> 4U], kDigits[byte & 15U]};
  }
  return word;
}

Result<Endpoint> parsePcap(std::string_view text) {
  Endpoint endpoint;
  endpoint.scheme = Endpoint::Scheme::pcap;
  const std::string_view rest = text.substr(kPcapScheme.size());
  const std::size_t question = std::min(rest.find('?'), rest.size());
  const std::string_view place = rest.substr(0, question);
  if (place.find('/') != place.npos) {
    const auto file = decodePercent(place);
    if (!file) return badEndpoint(text, "a % in a file's name is written %25, as in URLs");
    endpoint.file = *file;
  } else {
    if (!isInterfaceName(place)) {
      return badEndpoint(text,
                         "pcap:// needs a network interface, such as eth0 or any, or a "
                         "capture file with a / in its name");
    }
    endpoint.interface = place;
  }
  if (question == rest.size()) return endpoint;
  const std::string_view option = rest.substr(question + 1);
  if (!option.starts_with(kFilter)) {
    return badEndpoint(text, "the only option of a pcap:// endpoint is filter=");
  }
  // The filter is the whole rest: & and ? have a meaning in filters.
  const auto filter = decodePercent(option.substr(kFilter.size()));
  if (!filter) return badEndpoint(text, "a % in filter= is written %25, as in URLs");
  if (filter->find_first_not_of(' ') == filter->npos) {
    return badEndpoint(text, "filter= takes what tcpdump takes, such as udp port 5000");
  }
  endpoint.filter = *filter;
  return endpoint;
}

std::string pcapText(const Endpoint& endpoint) {
  std::string text(kPcapScheme);
  text += endpoint.file.empty() ? endpoint.interface : encodePercent(endpoint.file, "?");
  if (!endpoint.filter.empty()) {
    text += '?';
    text += kFilter;
    text += encodePercent(endpoint.filter, "");
  }
  return text;
}

}  // namespace rocinante
