#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "core/base/bytes.h"
#include "core/packet/packet.h"
#include "core/recording/flow_table.h"

namespace rocinante {

/// A packet made of octets, for the channel beside theirs (docs/log-format.md, "Decoded packets").
struct MadePacket {
  std::size_t decoder = 0;  ///< its number: packets of one have one channel beside each flow's
  /// Metadata added to that of the octets' channel; lives as long as the decoder.
  const std::map<std::string, std::string>* metadata = nullptr;
  std::string_view text;
  const Packet* packet = nullptr;  ///< of `text`
};

/// Makes packets of datagrams that are not packet text. One thread; reads no clock.
class OctetDecoder {
 public:
  virtual ~OctetDecoder() = default;

  /// Null when no packet can be made of it. Borrowed until the next call.
  virtual const MadePacket* decode(const FlowChannel& channel, std::int64_t publish_time_ns,
                                   ByteView octets) = 0;
};

}  // namespace rocinante
