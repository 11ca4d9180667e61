#include "core/foreign/decode/carried_decoders.h"

#include <charconv>

#include "core/log/log_profile.h"

namespace rocinante::decode {

std::vector<CarriedFile> carriedFiles(const DecoderSet& set, LogTime time) {
  const std::string name = std::string(profile::kDecodersFolder) + set.hash;
  std::vector<CarriedFile> files;
  const auto add = [&](std::string called, const char* media_type, std::string_view content) {
    files.push_back(
        {{std::move(called), media_type, time, content.size()}, rocinante::bytesOf(content)});
  };
  add(name + ".toml", "application/toml", set.text);
  for (const DescriptorFiles::File& each : set.descriptors) {
    add(name + "/" + each.name, "application/protobuf", each.bytes);
  }
  return files;
}

Status attachDecoders(const DecoderSet& set, LogWriter& log, LogTime time) {
  for (const CarriedFile& file : carriedFiles(set, time)) {
    const LogAttachment& attachment = file.attachment;
    Status written = log.writeAttachment(attachment.name, attachment.media_type, time, file.bytes);
    if (!written) return written;
  }
  return {};
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
