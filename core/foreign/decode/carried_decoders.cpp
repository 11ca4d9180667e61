#include "core/foreign/decode/carried_decoders.h"

#include <charconv>

#include "core/log/log_profile.h"

namespace rocinante::decode {

LogAttachment attachmentOf(const DecoderSet& set, LogTime time) {
  return {std::string(profile::kDecodersFolder) + set.hash + ".toml", "application/toml", time,
          set.text.size()};
}

Status attachDecoders(const DecoderSet& set, LogWriter& log, LogTime time) {
  const LogAttachment attachment = attachmentOf(set, time);
  return log.writeAttachment(attachment.name, attachment.media_type, time,
                             rocinante::bytesOf(set.text));
}

std::map<std::string, std::string> decodedMetadata(const DecoderSet& set, std::size_t decoder) {
  return {{"source", std::string(profile::kDecodedSource) + set.decoders[decoder].name},
          {std::string(profile::kDecoderKey), set.hash}};
}

Route routeOf(std::string_view topic, const std::map<std::string, std::string>& metadata) {
  Route route;
  route.topic = topic;
  if (const auto remote = metadata.find("remote"); remote != metadata.end()) {
    route.sender = remote->second;
  }
  const auto local = metadata.find("local");
  if (local == metadata.end()) return route;
  const std::string& text = local->second;
  const std::size_t colon = text.rfind(':');
  if (colon == text.npos) return route;
  const char* const end = text.data() + text.size();
  std::uint16_t port = 0;
  const auto [stop, fault] = std::from_chars(text.data() + colon + 1, end, port);
  if (fault == std::errc() && stop == end) route.port = port;
  return route;
}

}  // namespace rocinante::decode
