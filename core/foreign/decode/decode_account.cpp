#include "core/foreign/decode/decode_account.h"

#include <fmt/format.h>

#include "core/base/figure_text.h"
#include "core/report/json_text.h"

namespace rocinante::decode {

std::uint64_t DecodeAccount::decoded() const {
  std::uint64_t decoded = 0;
  for (const Decoder& each : decoders) decoded += each.counts.decoded;
  return decoded;
}

DecodeAccount accountOf(const DatagramDecoders& decoders, std::uint64_t octets) {
  DecodeAccount account;
  account.octets = octets;
  account.left_out = decoders.leftOut();
  for (std::size_t i = 0; i < decoders.counts().size(); ++i) {
    account.decoders.push_back({decoders.set().decoders[i].name, decoders.counts()[i]});
  }
  return account;
}

std::string accountText(const DecodeAccount& account) {
  std::string text;
  for (const DecodeAccount::Decoder& each : account.decoders) {
    const DecodeCounts& counts = each.counts;
    text += fmt::format("  {}: {}", each.name, countText(counts.decoded, "packet"));
    if (counts.refused > 0) {
      text += fmt::format(", {} refused: {}", counts.refused, counts.last_reason);
    }
    if (counts.empty > 0) text += fmt::format(", {} without its fields", counts.empty);
    text += '\n';
  }
  if (const std::uint64_t decoded = account.decoded(); decoded < account.octets) {
    text += fmt::format("  not decoded: {}\n", countText(account.octets - decoded, "datagram"));
  }
  if (!account.left_out.empty()) text += fmt::format("  {}\n", accountSentence(account.left_out));
  return text;
}

Json accountJson(const DecodeAccount& account) {
  Json json;
  json["octets"] = account.octets;
  json["packets"] = account.decoded();
  json["decoders"] = Json::array();
  for (const DecodeAccount::Decoder& each : account.decoders) {
    Json decoder;
    decoder["decoder"] = each.name;
    decoder["packets"] = each.counts.decoded;
    decoder["refused"] = each.counts.refused;
    decoder["empty"] = each.counts.empty;
    decoder["reason"] = orNull(std::string(each.counts.last_reason));
    json["decoders"].push_back(std::move(decoder));
  }
  json["left_out"] = leftOutJson(account.left_out);
  return json;
}

}  // namespace rocinante::decode
