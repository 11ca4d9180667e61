#include "golden/check/log_octets.h"

#include <algorithm>

#include "core/foreign/decode/carried_decoders.h"
#include "core/foreign/live/received_decoder.h"

namespace rocinante {
namespace {

bool hasOctets(const LogReader& log) {
  return std::ranges::any_of(log.channels(), [](const LogChannel& channel) {
    return channel.captured() && !channel.imported() && channel.encoding != "rk1";
  });
}

}  // namespace

Result<LogOctets> LogOctets::of(const LogReader& log, const std::string& file, const Cell& cell) {
  LogOctets octets;
  if (file.empty() && !hasOctets(log)) return octets;
  auto set = decodersFor(file, cell);
  if (!set) return set.error();
  if (!*set) return octets;
  octets.decoders_.emplace(*set);
  octets.again_.emplace(std::move(*set));
  return octets;
}

DecodedOctets LogOctets::packetOf(const LogMessage& message, bool has_packet) {
  octets_ += has_packet ? 0 : 1;
  decode::DatagramDecoders& decoders = has_packet ? *again_ : *decoders_;
  const decode::DecodedPacket* const packet =
      decoders.decode(decode::routeOf(*message.channel), message.publish_time_ns, message.payload);
  return {packet == nullptr ? std::string_view() : packet->text, decoders.notFinite()};
}

}  // namespace rocinante
