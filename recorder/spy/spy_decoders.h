#pragma once

#include <memory>
#include <vector>

#include "core/foreign/decode/field_reader.h"
#include "core/foreign/live/received_decoder.h"
#include "recorder/spy/spy_report.h"

namespace rocinante {

/// Declared decoders at a spy: the packets that they make, and for people who write a declaration
/// the fields of the last datagram of each. Keeps one datagram a decoder. One thread.
class SpyDecoders {
 public:
  SpyDecoders(std::shared_ptr<const decode::DecoderSet> set,
              std::vector<ListenedEndpoint> endpoints);

  /// As ReceivedDecoder's.
  const MadePacket* decode(std::size_t endpoint, const ReceivedDatagram& datagram, LogTime time);

  /// Datagrams of which a packet was made.
  std::uint64_t decoded() const { return received_.decoder().account().decoded(); }
  /// By decoder, as declared.
  std::vector<SpyDecoder> report();

 private:
  /// What the last datagram of a decoder has.
  struct Last {
    std::unique_ptr<decode::FieldReader> reader;
    Bytes datagram;
    bool any = false;
    bool decoded = false;  ///< a packet was made of it
  };

  const decode::DecoderSet& set() const { return received_.decoder().decoders().set(); }
  void readFields(std::size_t decoder, SpyDecoder& report);

  ReceivedDecoder received_;
  std::vector<Last> last_;  ///< by decoder
};

}  // namespace rocinante
