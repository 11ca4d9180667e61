#pragma once

#include <map>
#include <string>

#include "core/foreign/decode/datagram_decoders.h"
#include "core/log/log_types.h"
#include "core/log/log_writer.h"

namespace rocinante::decode {

/// The attachment that carries the declaration (docs/log-format.md, "Decoded packets"); its content
/// is the text of the set.
LogAttachment attachmentOf(const DecoderSet& set, LogTime time);
Status attachDecoders(const DecoderSet& set, LogWriter& log, LogTime time);

/// What a channel of decoded packets has beside the metadata of its octets: `source`, `decoder`.
std::map<std::string, std::string> decodedMetadata(const DecoderSet& set,
                                                   const DecodedPacket& packet);

/// The route of a recorded message, from its channel's metadata; borrowed from the channel.
Route routeOf(const LogChannel& channel);

}  // namespace rocinante::decode
