#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/foreign/decode/datagram_decoders.h"
#include "core/log/log_types.h"
#include "core/log/log_writer.h"

namespace rocinante::decode {

struct CarriedFile {
  LogAttachment attachment;
  ByteView bytes;  ///< the set's
};

/// The attachments that carry the declaration and its descriptors (docs/log-format.md, "Decoded
/// packets").
std::vector<CarriedFile> carriedFiles(const DecoderSet& set, LogTime time);
Status attachDecoders(const DecoderSet& set, LogWriter& log, LogTime time);

/// What a channel of decoded packets has beside the metadata of its octets: `source`, `decoder`.
std::map<std::string, std::string> decodedMetadata(const DecoderSet& set, std::size_t decoder);

/// The route of a message from its channel's topic and metadata, of which it borrows.
Route routeOf(std::string_view topic, const std::map<std::string, std::string>& metadata);
inline Route routeOf(const LogChannel& channel) { return routeOf(channel.topic, channel.metadata); }

}  // namespace rocinante::decode
