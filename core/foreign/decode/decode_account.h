#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/foreign/decode/datagram_decoders.h"
#include "core/report/json_name.h"

namespace rocinante::decode {

/// What became of the datagrams of a session that are not packet text.
struct DecodeAccount {
  struct Decoder {
    std::string name;
    DecodeCounts counts;
  };
  std::vector<Decoder> decoders;  ///< as declared
  std::uint64_t octets = 0;       ///< datagrams that are not packet text
  Account left_out{};             ///< see DatagramDecoders::leftOut()

  std::uint64_t decoded() const;
};

DecodeAccount accountOf(const DatagramDecoders& decoders, std::uint64_t octets);

/// A line for each decoder, one for what none understood and one for values that were left out,
/// indented and with LF.
std::string accountText(const DecodeAccount& account);

/// {"octets", "packets", "decoders": [{"decoder", "packets", "refused", "empty", "reason"}],
/// "left_out"}.
Json accountJson(const DecodeAccount& account);

}  // namespace rocinante::decode
